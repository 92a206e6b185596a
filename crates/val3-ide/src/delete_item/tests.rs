//! Deletion of declarations in both dialects.

use expect_test::{Expect, expect};

use super::*;
use crate::assists::shown;
use crate::testing::{MarkedListing, shown_all};

fn check(listing: &str, expected: Expect) {
    let marked = MarkedListing::new(listing);
    let db = marked.db();
    let text = match delete_item(db, marked.at()) {
        Ok(Deletion { change, uses }) => format!("{}used at\n{}", shown(db, &change), shown_all(db, uses)),
        Err(RefactoringError(reason)) => reason + "\n",
    };
    expected.assert_eq(&text);
}

#[test]
fn a_program_goes_with_its_file_and_its_entry() {
    check(
        "call pick()\n=== main/pick.pgx\n<Programs>\n  <Program name=\"pi$0ck\">\n    <Code>begin\ncall pick()\nend</Code>\n  </Program>\n</Programs>",
        expect![[r#"
        usrapp/main/main.pjx
        -    <Program file="pick.pgx" />
        usrapp/main/pick.pgx goes
        used at
        main/start.pgx:5 pick
    "#]],
    );
}

#[test]
fn the_last_program_of_several_projects_leaves_every_list() {
    check(
        "cls()\n=== main/main.pjx\n<Project><Programs><Program file=\"start.pgx\" /></Programs></Project>\n\
         === main/start.pgx\n<Programs><Program name=\"sta$0rt\"><Code>begin\nend</Code></Program></Programs>\n\
         === main/other.pjx\n<Project>\n  <Programs>\n    <Program file=\"start.pgx\" />\n  </Programs>\n</Project>",
        expect![[r#"
            usrapp/main/main.pjx
            -<Project><Programs><Program file="start.pgx" /></Programs></Project>
            +<Project><Programs></Programs></Project>
            usrapp/main/other.pjx
            -    <Program file="start.pgx" />
            usrapp/main/start.pgx goes
            used at
        "#]],
    );
}

#[test]
fn data_of_both_dialects_go() {
    check(
        &format!(
            "nA=nB\n=== main/main.dtx\n<Database>\n  <Datas>\n{}{}  </Datas>\n</Database>",
            data("n$0A"),
            data("nB")
        ),
        expect![[r#"
            usrapp/main/main.dtx
            -    <Data name="nA" access="private" xsi:type="array" type="num" size="1">
            -      <Value key="0" value="1" />
            -    </Data>
            used at
            main/start.pgx:5 nA
        "#]],
    );
    check(
        "nA=1\n=== main/main.dtx\n<dataList>\n  <numSection>\n    <num name=\"n$0A\" public=\"false\" size=\"1\">\n      <valueNum index=\"0\" value=\"7\" />\n    </num>\n  </numSection>\n</dataList>",
        expect![[r#"
            usrapp/main/main.dtx
            -  <numSection>
            -    <num name="nA" public="false" size="1">
            -      <valueNum index="0" value="7" />
            -    </num>
            -  </numSection>
            +  <numSection />
            used at
            main/start.pgx:5 nA
        "#]],
    );
}

fn data(name: &str) -> String {
    format!(
        "    <Data name=\"{name}\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\">\n      <Value key=\"0\" value=\"1\" />\n    </Data>\n"
    )
}

#[test]
fn entries_of_libraries_and_types_go() {
    check(
        &with_references("pa$0rt", "Part"),
        expect![[r#"
        usrapp/main/main.pjx
        -    <Library alias="part" path="Disk://part/part.pjx" />
        used at
        main/start.pgx:5 part
    "#]],
    );
    check(
        &with_references("part", "Par$0t"),
        expect![[r#"
        usrapp/main/main.pjx
        -    <Type name="Part" path="Disk://part/part.pjx" />
        used at
    "#]],
    );
}

/// A project with a library identifier and a user type.
fn with_references(library: &str, ty: &str) -> String {
    format!(
        "part:nA=1\n=== main/main.pjx\n<Project>\n  <Programs>\n    <Program file=\"start.pgx\" />\n  </Programs>\n  <Database>\n    <Data file=\"main.dtx\" />\n  </Database>\n  <Libraries>\n    <Library alias=\"{library}\" path=\"Disk://part/part.pjx\" />\n  </Libraries>\n  <Types>\n    <Type name=\"{ty}\" path=\"Disk://part/part.pjx\" />\n  </Types>\n</Project>\n--- part\npublic num nA"
    )
}

#[test]
fn the_second_of_two_entries_of_a_name_goes_alone() {
    check(
        "cls()\n=== main/main.pjx\n<project>\n  <aliasSection>\n    <alias name=\"part\" interface=\"one\" />\n    <alias name=\"pa$0rt\" interface=\"two\" />\n  </aliasSection>\n</project>",
        expect![[r#"
            usrapp/main/main.pjx
            -    <alias name="part" interface="two" />
            used at
            main/main.pjx:4 part
        "#]],
    );
}

#[test]
fn broken_files_and_files_with_several_programs_stay() {
    check(
        "cls()\n=== main/main.dtx\n<Database>\n  <Datas>\n    <Data name=\"n$0A\" type=\"num\">\n    <Data name=\"nB\" type=\"num\" />\n  </Datas>\n</Database>",
        expect![[r#"
            the file has a syntax error; correct it in the text first
        "#]],
    );
    check(
        "cls()\n=== main/two.pgx\n<Programs><Program name=\"tw$0o\"><Code>begin\nend</Code></Program><Program name=\"b\"><Code>begin\nend</Code></Program></Programs>",
        expect![[r#"
            `two.pgx` has more programs than this one. Delete it in the text
        "#]],
    );
    check(
        "cls$0()",
        expect![[r#"
        there is no program, data, library or type declared here
    "#]],
    );
}
