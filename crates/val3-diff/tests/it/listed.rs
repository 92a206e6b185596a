//! Listed files: only files in the project file are compared, in its order.

use expect_test::expect;
use val3_diff::{FileTree, compare};

use crate::support::human;

fn project(files: &[&str]) -> String {
    let files: String = files.iter().map(|file| format!("<Data file=\"{file}\"/>")).collect();
    format!("<Project><Programs><Program file=\"start.pgx\"/></Programs><Database>{files}</Database></Project>")
}

fn frame(x: i32) -> String {
    format!(
        "<Database><Datas><Data name=\"fA\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\"><Value \
         key=\"0\" x=\"{x}\" fatherId=\"world[0]\"/></Data></Datas></Database>"
    )
}

fn program(code: &str) -> String {
    format!("<Programs><Program name=\"start\"><Code><![CDATA[begin\n{code}\nend]]></Code></Program></Programs>")
}

fn tree(files: &[(&str, String)]) -> FileTree {
    let start = [("a/start.pgx".to_owned(), program(""))];
    FileTree::new(start.into_iter().chain(files.iter().map(|(name, text)| (format!("a/{name}"), text.clone()))))
}

/// Returns the report on two versions of the application `a`.
fn report(old: &[(&str, String)], new: &[(&str, String)]) -> String {
    human(&compare(&tree(old), &tree(new)))
}

#[test]
fn a_copy_that_no_project_lists_hides_no_difference() {
    for copy in ["a - Copy.dtx", "0.dtx", "a.bak.dtx", "z.dtx"] {
        let files = |x: i32, copied: i32| [("a.pjx", project(&["a.dtx"])), ("a.dtx", frame(x)), (copy, frame(copied))];
        let moved = report(&files(0, 0), &files(1600, 0));
        assert!(moved.contains("1600.000 mm"), "{copy}: {moved}");
        let unmoved = report(&files(0, 0), &files(0, 1600));
        assert!(!unmoved.contains("mm") && unmoved.contains(copy), "{copy}: {unmoved}");
    }
}

#[test]
fn the_order_of_the_project_decides() {
    let files = |list: &[&str]| [("a.pjx", project(list)), ("a.dtx", frame(0)), ("b.dtx", frame(1600))];
    expect![[r#"
        a  a/a.pjx
          Project
            ~ data files  a.dtx, b.dtx → b.dtx, a.dtx
          Points, frames and tools
              Position        Moved  Turned     In world  Values
            ~ fA        1600.000 mm          1600.000 mm  x 0 → 1600

        1 application differs: 1 position, 1 setting
    "#]]
    .assert_eq(&report(&files(&["a.dtx", "b.dtx"]), &files(&["b.dtx", "a.dtx"])));
    expect![[r#"
        a  a/a.pjx
          Project
            ~ data files  a.dtx → b.dtx
          Points, frames and tools
              Position        Moved  Turned     In world  Values
            ~ fA        1600.000 mm          1600.000 mm  x 0 → 1600

        1 application differs: 1 position, 1 setting
    "#]]
    .assert_eq(&report(&files(&["a.dtx"]), &files(&["b.dtx"])));
    expect![[r#"
        a  a/a.pjx
          Project
            ~ data files  a.dtx → (not written)
          Points, frames and tools
            - frame fA = father world

        1 application differs: 1 position, 1 setting
    "#]]
    .assert_eq(&report(&files(&["a.dtx"]), &files(&[])));
}

#[test]
fn a_program_that_no_project_lists_is_a_file() {
    let files = |code: &str| [("a.pjx", project(&[])), ("start - Copy.pgx", program(code))];
    expect![[r#"
        a  a/a.pjx
          Files compared as text
            ~ a/start - Copy.pgx
              1   <Programs><Program name="start"><Code><![CDATA[begin
              2 - cls()
              2 + delay(1)
              3   end]]></Code></Program></Programs>

        1 application differs: 1 file as text
    "#]]
    .assert_eq(&report(&files("cls()"), &files("delay(1)")));
}

fn files_with_fields(size: &str) -> [(&'static str, String); 2] {
    let data = format!(
        "<Database><Datas><Data name=\"rA\" access=\"private\" xsi:type=\"array\" type=\"Rec\" size=\"1\"><Value \
         key=\"0\"><Field name=\"nArr\" xsi:type=\"array\" type=\"num\" size=\"{size}\"/><Field name=\"rIn\" \
         xsi:type=\"array\" type=\"Rec\" size=\"1\"><Value key=\"0\"><Field name=\"pArr\" xsi:type=\"array\" \
         type=\"pointRx\" size=\"{size} 4\"/></Value></Field></Value></Data></Datas></Database>"
    );
    [("a.pjx", project(&["a.dtx"])), ("a.dtx", data)]
}

#[test]
fn sizes_of_fields_differ() {
    expect![[r#"
        a  a/a.pjx
          Data
            ~ rA.nArr  size 2 → 5
            ~ rA.rIn.pArr  size 2 x 4 → 5 x 4

        1 application differs: 2 values
    "#]]
    .assert_eq(&report(&files_with_fields("2"), &files_with_fields("5")));
}

fn profiles(level: i32) -> FileTree {
    let profile = format!("<profile><right name=\"manualMode\" level=\"{level}\"/></profile>");
    let files =
        ["profiles/default.cfx", "templates/a/b.cfx"].map(|name| (format!("usr/configs/{name}"), profile.clone()));
    FileTree::new(files)
}

#[test]
fn settings_in_any_folder_of_the_configuration_differ() {
    expect![[r#"
        configs/profiles/default.cfx  configuration of the controller
            ~ right[manualMode] level  1 → 3

        configs/templates/a/b.cfx  configuration of the controller
            ~ right[manualMode] level  1 → 3

        the configuration differs: 2 settings
    "#]]
    .assert_eq(&human(&compare(&profiles(1), &profiles(3))));
}

fn backup(recipe: &str, gone: &[(&str, &str)]) -> FileTree {
    let files = [("usr/usrapp/a/a.pjx", project(&[])), ("usr/usrapp/txt/12.txt", recipe.to_owned())];
    let more = gone.iter().map(|(path, text)| (*path, (*text).to_owned()));
    FileTree::new(files.into_iter().chain(more))
}

#[test]
fn other_files_of_a_backup_differ_by_their_bytes() {
    let old = backup("1 2", &[("usr/app/addon.dll", "a"), ("usr/usrapp/a/interface/p.html", "<p/>")]);
    let new = backup("1 3", &[("usr/app/addon.dll", "a"), ("usr/usrapp/a/interface/q.html", "<p/>")]);
    expect![[r#"
        Other files  compared by their bytes
            - a/interface/p.html  the file was removed
            + a/interface/q.html  new file
            ~ txt/12.txt

        3 other files differ
    "#]]
    .assert_eq(&human(&compare(&old, &new)));
    assert!(compare(&old, &old).is_empty());
    let mut only = compare(&old, &new);
    only.keep(&[val3_diff::ReportClass::Programs]);
    assert!(only.is_empty());
    let many = (0..30).map(|number| (format!("usr/log/{number}.txt"), "x"));
    let report = human(&compare(&FileTree::default(), &FileTree::new(many)));
    assert!(report.ends_with("and 10 more; `--format json` names all\n\n30 other files differ\n"), "{report}");
}
