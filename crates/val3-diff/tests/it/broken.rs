//! Broken, missing and hostile files.

use expect_test::expect;
use val3_diff::{FileTree, compare, listing};

use crate::support::{check, human};

#[test]
fn a_broken_data_file_is_compared_as_text() {
    let old = "num nA\n=== main/main.dtx\n<Database>\n<Datas>\n<Data name=\"nA\"/>\n</Datas>\n</Database>";
    let new = "num nA\n=== main/main.dtx\n<Database>\n<Datas>\n<Data name=\"nB\"\n</Datas>\n</Database>";
    check(
        old,
        new,
        &expect![[r#"
            main  main/main.pjx
              Files compared as text
                ~ main/main.dtx
                  1   <Database>
                  2   <Datas>
                  3 - <Data name="nA"/>
                  3 + <Data name="nB"
                  4   </Datas>
                  5   </Database>

            Notes
                ! main/main.dtx  in the new version this is not a data file, so the file was compared as text; `val3 check` shows the faults

            1 application differs: 1 file as text
        "#]],
    );
}

#[test]
fn a_broken_program_and_a_broken_project_are_compared_as_text() {
    let old = "cls()";
    let new = "cls()\n=== main/start.pgx\n<Programs><Program name=\"start\"><Code>\n=== main/main.pjx\n<<<<<<< HEAD\n<Project>";
    check(
        old,
        new,
        &expect![[r#"
            main  main/main.pjx
              Files compared as text
                ~ main/main.pjx
                   1 - <?xml version="1.0" encoding="utf-8"?>
                   2 - <Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">
                   3 -   <Parameters version="s7.11" stackSize="5000" millimeterUnit="true" />
                   4 -   <Programs>
                   5 -     <Program file="start.pgx" />
                   6 -   </Programs>
                   7 -   <Database>
                   8 -     <Data file="main.dtx" />
                   9 -   </Database>
                  10 -   <Libraries />
                  11 -   <Types />
                  12 - </Project>
                   1 + <<<<<<< HEAD
                   2 + <Project>
                ~ main/start.pgx
                  1 - <?xml version="1.0" encoding="utf-8"?>
                  2 - <Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
                  3 -   <Program name="start">
                  4 -     <Code><![CDATA[begin
                  5 - cls()
                  6 - end]]></Code>
                  7 -   </Program>
                  8 - </Programs>
                  1 + <Programs><Program name="start"><Code>

            Notes
                ! main/main.pjx  in the new version this is not a project file, so the file was compared as text; `val3 check` shows the faults
                ! main/start.pgx  in the new version this is not a program file, so the file was compared as text; `val3 check` shows the faults

            1 application differs: 2 files as text
        "#]],
    );
}

fn tree(has_program: bool) -> FileTree {
    let program = "<Programs><Program name=\"start\"><Code>begin\nend</Code></Program></Programs>";
    let project = "<Project><Programs><Program file=\"START.pgx\"/><Program file=\"other.pgx\"/></Programs></Project>";
    let files = [("a.pjx", project), ("start.pgx", program), ("a.dtx", "<Database/>")];
    FileTree::new(files.into_iter().filter(move |(path, _)| has_program || *path != "start.pgx"))
}

#[test]
fn a_missing_program_is_reported_if_it_was_there() {
    expect![[r#"
        a  a.pjx
          Programs
            - start()  2 lines

        Notes
            ! a.pjx  in the new version the project file lists `START.pgx`, and there is no such file; restore it, or remove the entry

        1 application differs: 1 program
    "#]]
    .assert_eq(&human(&compare(&tree(true), &tree(false))));
}

#[test]
fn unreadable_bytes_are_compared() {
    let tree = |bytes: &[u8]| FileTree::new([("a.pgx", bytes.to_vec())]);
    expect![[r#"
        a.pgx
          Files compared as text
            ~ a.pgx  the bytes differ

        Notes
            ! a.pgx  in the old version the file cannot be read: its text is UTF-16; save it as UTF-8
            ! a.pgx  in the new version the file cannot be read: its text is UTF-16; save it as UTF-8

        1 application differs: 1 file as text
    "#]]
    .assert_eq(&human(&compare(&tree(b"\xff\xfea\0"), &tree(b"\xff\xfeb\0"))));
    assert!(compare(&tree(b"\xff\xfea\0"), &tree(b"\xff\xfea\0")).is_empty());
}

#[test]
fn deep_nesting_and_long_chains_end() {
    let deep = "<Field name=\"f\" type=\"T\"><Value key=\"0\">".repeat(5000);
    let text = format!("<Database><Datas><Data name=\"d\" type=\"T\" size=\"1\"><Value key=\"0\">{deep}");
    let frames: String = (0..5000)
        .map(|index| format!("<Data name=\"f{index}\" type=\"frame\" size=\"1\"><Value key=\"0\" x=\"1\" fatherId=\"f{}[0]\"/></Data>", index + 1))
        .collect();
    let chain = |x: &str| format!("<Database><Datas>{}</Datas></Database>", frames.replacen("x=\"1\"", x, 4000));
    let tree = |text: &str| FileTree::new([("a.dtx", text)]);
    assert!(!compare(&tree(&text), &tree("<Database/>")).is_empty());
    assert!(!compare(&tree(&chain("x=\"1\"")), &tree(&chain("x=\"2\""))).is_empty());
}

#[test]
fn any_file_has_a_listing() {
    let listed = |path: &str, text: &str| listing(path.into(), text.as_bytes()).unwrap();
    assert_eq!(listed("a.pgx", "<broken"), "<broken");
    assert_eq!(listed("a.txt", "text"), "text");
    let program = "<Programs><Program name=\"p\" access=\"public\"><Locals><Local name=\"l_n\" type=\"num\" xsi:type=\"array\" size=\"2\"/>\
        </Locals><Code><![CDATA[begin\r\n  cls()\r\nend]]></Code></Program></Programs>";
    assert_eq!(listed("p.pgx", program), "public program p()\n  num l_n[2]\nbegin\n  cls()\nend\n");
    let data = "<Database><Datas><Data name=\"nA\" access=\"public\" xsi:type=\"array\" type=\"num\" size=\"2\"><Value key=\"1\" value=\"5\"/>\
        </Data></Datas></Database>";
    assert_eq!(listed("a.dtx", data), "public num nA[2]\n  nA[1] = 5\n");
    let project = "<Project><Parameters version=\"s7.11\"/><Programs><Program file=\"p.pgx\"/></Programs></Project>";
    assert_eq!(listed("a.pjx", project), "version s7.11\nprogram p.pgx\n");
    assert!(listing("a.dtx".into(), b"\xff\xfe").is_err());
}
