//! Renaming, creating and deleting files of a small cell.

use expect_test::{Expect, expect};
use val3_test::ROOT;

use super::*;
use crate::assists::shown;
use crate::testing::MarkedListing;

const CELL: &str = "library part \"Disk://part/part.pjx\"\nlibrary near \"./tray/tray.pjx\"\ntype Slot \"Disk://types/Slot\"\nSlot sA\ncall pick()\nputln(part:libLoad(\"Disk://part\"))\ncall part:weigh()\nprogram pick()\nbegin\n  call pick()\nend\n--- part\npublic program weigh()\nbegin\nend\n--- main/tray\nlibrary part \"../../part/part.pjx\"\npublic num nA\n--- types/Slot\npublic num nHeight\n";

fn path(name: &str) -> Utf8PathBuf {
    Utf8PathBuf::from(format!("{ROOT}/usrapp/{name}"))
}

#[track_caller]
fn renamed(from: &str, to: &str, expected: Expect) {
    let marked = MarkedListing::new(CELL);
    let change = will_rename_files(marked.db(), &[(path(from), path(to))]);
    expected.assert_eq(&shown(marked.db(), &change));
}

#[test]
fn renaming_a_program_file_changes_its_entry() {
    renamed(
        "main/pick.pgx",
        "main/grip.pgx",
        expect![[r#"
        usrapp/main/main.pjx
        -    <Program file="pick.pgx" />
        +    <Program file="grip.pgx" />
        usrapp/main/pick.pgx
        -  <Program name="pick">
        -    <Code><![CDATA[begin
        -  call pick()
        +  <Program name="grip">
        +    <Code><![CDATA[begin
        +  call grip()
        usrapp/main/start.pgx
        -call pick()
        +call grip()
    "#]],
    );
    renamed(
        "main/pick.pgx",
        "main/not a name.pgx",
        expect![[r#"
        usrapp/main/main.pjx
        -    <Program file="pick.pgx" />
        +    <Program file="not a name.pgx" />
    "#]],
    );
    renamed(
        "part/weigh.pgx",
        "part/sub/weigh.pgx",
        expect![[r#"
        usrapp/part/part.pjx
        -    <Program file="weigh.pgx" />
        +    <Program file="sub/weigh.pgx" />
    "#]],
    );
    renamed(
        "part/weigh.pgx",
        "main/weigh.pgx",
        expect![[r#"
        usrapp/main/main.pjx
        +    <Program file="weigh.pgx" />
        usrapp/part/part.pjx
        -    <Program file="weigh.pgx" />
    "#]],
    );
}

#[test]
fn paths_in_another_letter_case_are_changed() {
    renamed(
        "MAIN/PICK.pgx",
        "Main/grip.pgx",
        expect![[r#"
            usrapp/main/main.pjx
            -    <Program file="pick.pgx" />
            +    <Program file="grip.pgx" />
            usrapp/main/pick.pgx
            -  <Program name="pick">
            -    <Code><![CDATA[begin
            -  call pick()
            +  <Program name="grip">
            +    <Code><![CDATA[begin
            +  call grip()
            usrapp/main/start.pgx
            -call pick()
            +call grip()
        "#]],
    );
    let marked = MarkedListing::new(CELL);
    let lower = will_rename_files(marked.db(), &[(path("part"), path("piece"))]);
    let upper = will_rename_files(marked.db(), &[(path("Part"), path("piece"))]);
    assert!(!lower.is_empty());
    assert_eq!(shown(marked.db(), &upper), shown(marked.db(), &lower));
    let created = will_create_files(marked.db(), &[path("Main/new.pgx")]);
    assert!(shown(marked.db(), &created).contains("new.pgx"));
}

#[test]
fn renaming_data_and_project_files_changes_references() {
    renamed(
        "part/part.dtx",
        "part/data.dtx",
        expect![[r#"
        usrapp/part/part.pjx
        -    <Data file="part.dtx" />
        +    <Data file="data.dtx" />
    "#]],
    );
    renamed(
        "part/part.pjx",
        "part/unit.pjx",
        expect![[r#"
        usrapp/main/main.pjx
        -    <Library alias="part" path="Disk://part/part.pjx" />
        +    <Library alias="part" path="Disk://part/unit.pjx" />
        usrapp/main/start.pgx
        -putln(part:libLoad("Disk://part"))
        +putln(part:libLoad("Disk://part/unit.pjx"))
        usrapp/main/tray/tray.pjx
        -    <Library alias="part" path="../../part/part.pjx" />
        +    <Library alias="part" path="../../part/unit.pjx" />
    "#]],
    );
}

#[test]
fn renaming_folders_changes_paths() {
    renamed(
        "part",
        "unit",
        expect![[r#"
        usrapp/main/main.pjx
        -    <Library alias="part" path="Disk://part/part.pjx" />
        +    <Library alias="part" path="Disk://unit/part.pjx" />
        usrapp/main/start.pgx
        -putln(part:libLoad("Disk://part"))
        +putln(part:libLoad("Disk://unit/part.pjx"))
        usrapp/main/tray/tray.pjx
        -    <Library alias="part" path="../../part/part.pjx" />
        +    <Library alias="part" path="../../unit/part.pjx" />
    "#]],
    );
    renamed(
        "main",
        "deep/app",
        expect![[r#"
        usrapp/main/tray/tray.pjx
        -    <Library alias="part" path="../../part/part.pjx" />
        +    <Library alias="part" path="../../../part/part.pjx" />
    "#]],
    );
    renamed(
        "types",
        "kinds",
        expect![[r#"
        usrapp/main/main.pjx
        -    <Type name="Slot" path="Disk://types/Slot" />
        +    <Type name="Slot" path="Disk://kinds/Slot" />
    "#]],
    );
}

#[track_caller]
fn moved_parts(code: &str, from: &str, to: &str, expected: Expect) {
    let parts = "--- parts/p1\npublic num nA\n--- parts/p2\npublic num nA\n";
    let marked = MarkedListing::new(&format!("library part \"Disk://parts/p1/p1.pjx\"\nstring sName\n{code}\n{parts}"));
    let change = will_rename_files(marked.db(), &[(path(from), path(to))]);
    let shown = shown(marked.db(), &change);
    let (_, of_program) = shown.split_once("usrapp/main/start.pgx\n").unwrap_or(("", ""));
    expected.assert_eq(of_program);
}

#[test]
fn concatenated_paths_are_changed() {
    let code = "putln(part:libLoad(\"Disk://parts/\"+sName))";
    moved_parts(
        code,
        "parts",
        "kinds/all",
        expect![[r#"
        -putln(part:libLoad("Disk://parts/"+sName))
        +putln(part:libLoad("Disk://kinds/all/"+sName))
    "#]],
    );
    moved_parts(code, "parts/p1", "parts/p9", expect![""]);
    moved_parts(code, "parts/p1", "p1", expect![""]);
    moved_parts(code, "main", "deep/app", expect![""]);
    let partial = "putln(part:libLoad((\"Disk://parts/\"+\"p\")+sName+\".pjx\"))";
    moved_parts(
        partial,
        "parts",
        "kinds",
        expect![[r#"
        -putln(part:libLoad(("Disk://parts/"+"p")+sName+".pjx"))
        +putln(part:libLoad(("Disk://kinds/p")+sName+".pjx"))
    "#]],
    );
    moved_parts(partial, "parts/p1", "parts/q1", expect![""]);
    let beside = "putln(part:libLoad(\"../parts/\"+sName))";
    moved_parts(
        beside,
        "main",
        "deep/app",
        expect![[r#"
        -putln(part:libLoad("../parts/"+sName))
        +putln(part:libLoad("../../parts/"+sName))
    "#]],
    );
    moved_parts(
        beside,
        "parts",
        "kinds",
        expect![[r#"
        -putln(part:libLoad("../parts/"+sName))
        +putln(part:libLoad("../kinds/"+sName))
    "#]],
    );
    moved_parts(
        "putln(part:libLoad(\"disk://Parts/\"+sName))",
        "parts",
        "kinds",
        expect![[r#"
        -putln(part:libLoad("disk://Parts/"+sName))
        +putln(part:libLoad("disk://kinds/"+sName))
    "#]],
    );
    moved_parts("putln(part:libLoad(sName+\"/p1.pjx\"))", "parts", "kinds", expect![""]);
    moved_parts("putln(part:libLoad(\"USB0://parts/\"+sName))", "parts", "kinds", expect![""]);
    moved_parts("putln(part:libLoad(\"Disk://\"+sName))", "parts", "kinds", expect![""]);
}

#[test]
fn created_and_deleted_files_change_the_project() {
    let marked = MarkedListing::new(CELL);
    let db = marked.db();
    let new = ["main/b.pgx", "main/a.pgx", "main/more.dtx", "main/notes.txt", "part/x.pgx"].map(path);
    expect![[r#"
        usrapp/main/main.pjx
        -  </Programs>
        -  <Database>
        -    <Data file="main.dtx" />
        +    <Program file="b.pgx" />
        +    <Program file="a.pgx" />
        +  </Programs>
        +  <Database>
        +    <Data file="main.dtx" />
        +    <Data file="more.dtx" />
        usrapp/part/part.pjx
        +    <Program file="x.pgx" />
    "#]]
    .assert_eq(&shown(db, &will_create_files(db, &new)));
    let gone = ["main/pick.pgx", "main/main.dtx", "main/none.pgx"].map(path);
    expect![[r#"
        usrapp/main/main.pjx
        -    <Program file="pick.pgx" />
        -    <Program file="start.pgx" />
        -  </Programs>
        -  <Database>
        -    <Data file="main.dtx" />
        +    <Program file="start.pgx" />
        +  </Programs>
        +  <Database>
    "#]]
    .assert_eq(&shown(db, &will_delete_files(db, &gone)));
    assert!(will_create_files(db, &[path("main/pick.pgx")]).is_empty());
}
