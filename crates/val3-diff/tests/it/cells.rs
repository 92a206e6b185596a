//! Entire cells: their configuration, and applications that moved.

use expect_test::expect;
use val3_diff::{FileTree, compare};

use crate::support::{check, human};

#[test]
fn inputs_and_outputs_of_the_cell_are_compared() {
    let old = "dio dDoor\n=== /configs/bio.cfx\n<bio><bioDin index=\"0\" name=\"a\"/><bioDin index=\"1\" name=\"b\"/></bio>\n\
        === /configs/arm.cfx\n<arm><Float name=\"j1\" value=\"170\"/></arm>\n=== /configs/sio.cfx\n<sio/>";
    let new = "dio dDoor\n=== /configs/bio.cfx\n<bio><bioDin name=\"door\" index=\"0\" /><bioDin index=\"2\" name=\"c\"/></bio>\n\
        === /configs/arm.cfx\n<arm><Float name=\"j1\" value=\"160\"/></arm>\n=== /configs/cell.cfx\n<cell/>";
    check(
        old,
        new,
        &expect![[r#"
            configs/arm.cfx  configuration of the controller
                ~ Float[j1] value  170 → 160

            configs/bio.cfx  inputs and outputs
                ~ bioDin[0] name  a → door
                + bioDin[2] name  c
                - bioDin[1] name  b

            configs/cell.cfx  configuration of the controller
                + new file

            configs/sio.cfx  inputs and outputs
                - the file was removed

            the configuration differs: 4 inputs and outputs, 2 settings
        "#]],
    );
}

#[test]
fn a_backup_is_compared_with_its_applications() {
    let old = FileTree::new([("usr/usrapp/a/a.pjx", "<Project/>"), ("usr/configs/arm.cfx", "<arm x=\"1\"/>")]);
    let new = FileTree::new([("usrapp/a/a.pjx", "<Project/>"), ("configs/arm.cfx", "<arm x=\"1\"/>")]);
    assert!(compare(&old, &new).is_empty());
    let application = |path: &str| FileTree::new([(path, "<Project/>")]);
    assert!(compare(&application("usr/usrapp/a/a.pjx"), &application("a.pjx")).is_empty());
}

#[test]
fn an_application_in_another_folder_is_the_same() {
    let project = "<Project><Parameters version=\"s7\"/></Project>";
    let old = FileTree::new([("1/a/a.pjx", project)]);
    let new = FileTree::new([("2/a/a.pjx", project)]);
    expect![[r#"
        a  2/a/a.pjx, moved from 1/a/a.pjx

        1 application differs
    "#]]
    .assert_eq(&human(&compare(&old, &new)));
}

#[test]
fn new_and_missing_applications_are_summed_up() {
    check(
        "num nA\n--- gone\nnum nB",
        "num nA\n--- added\nnum nB\nnum nC",
        &expect![[r#"
            added  added/added.pjx
                + new: 2 global variables

            gone  gone/gone.pjx
                - removed: 1 global variable

            2 applications differ: 3 values
        "#]],
    );
}
