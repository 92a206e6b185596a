//! Contents of projects, and their kinds.

use expect_test::{Expect, expect};

use super::*;
use crate::testing::MarkedListing;

fn name(db: &dyn Db, project: Project) -> String {
    project.manifest(db).path(db).file_stem().unwrap().to_owned()
}

fn kinds(listing: &str, expected: Expect) {
    let marked = MarkedListing::new(listing);
    let db = marked.db();
    let mut lines: Vec<String> =
        project_kinds(db).into_iter().map(|(project, kind)| format!("{} {kind:?}\n", name(db, project))).collect();
    lines.sort();
    expected.assert_eq(&lines.concat());
}

const START: &str = "program start()\nbegin\n  cls()\nend\n";

#[test]
fn what_no_project_uses_and_has_a_start_is_an_application() {
    kinds(
        &format!(
            "library part \"Disk://part/part.pjx\"\ntype Slot \"Disk://Slot/Slot.pjx\"\ncls()\n\
             --- part\n{START}public num nA\n--- Slot\n{START}public num nA\n--- alone\npublic num nA\n\
             --- mainTest\nlibrary main \"Disk://main/main.pjx\"\n{START}"
        ),
        expect![[r#"
            Slot Type
            alone Library
            main Application
            mainTest Tests
            part Library
        "#]],
    );
}

#[test]
fn a_project_that_is_a_library_and_a_type_is_a_library() {
    kinds(
        "library slot \"Disk://Slot/Slot.pjx\"\ntype Slot \"Disk://Slot/Slot.pjx\"\ncls()\n--- Slot\npublic num nA",
        expect![[r#"
            Slot Library
            main Application
        "#]],
    );
}

#[test]
fn a_library_that_is_loaded_in_place_of_another_is_a_library() {
    kinds(
        &format!(
            "library part \"Disk://part/part.pjx\"\npart:libLoad(\"Disk://bag\")\n--- part\npublic num nA\n\
             --- bag\n{START}public num nA"
        ),
        expect![[r#"
            bag Library
            main Application
            part Library
        "#]],
    );
}

#[test]
fn in_a_circle_the_project_that_starts_something_is_the_application() {
    kinds(
        "library part \"Disk://part/part.pjx\"\ncls()\n--- part\nlibrary main \"Disk://main/main.pjx\"\n\
         library tray \"Disk://tray/tray.pjx\"\nprogram start()\nbegin\nend\npublic num nA\n\
         --- tray\nprogram start()\nbegin\n  cls()\nend\n",
        expect![[r#"
            main Application
            part Library
            tray Library
        "#]],
    );
}

fn content(listing: &str, expected: Expect) {
    let marked = MarkedListing::new(listing);
    let db = marked.db();
    let main = marked.workspace.projects.iter().find(|project| name(db, **project) == "main").unwrap();
    let ProjectContent { programs, data, libraries, types, has_types, .. } = project_content(db, *main);
    let mut lines = format!("has types: {has_types}\n");
    let mut line = |name: &str, detail: &str, rest: String| lines += &format!("{name}: {detail}; {rest}\n");
    for TreeItem { name, detail, what, .. } in &programs {
        line(name, detail, format!("public {}, runs {}", what.public, what.runs));
    }
    for TreeItem { name, detail, what, .. } in &data {
        line(name, detail, format!("public {}, {:?}", what.decl.public, what.value));
    }
    for TreeItem { name: alias, detail, what, .. } in libraries.iter().chain(&types) {
        let loaded: Vec<String> = what.loaded.iter().map(|project| name(db, *project)).collect();
        line(alias, detail, format!("{:?}, loaded {loaded:?}", what.project.map(|project| name(db, project))));
    }
    expected.assert_eq(&lines);
}

#[test]
fn programs_data_libraries_and_types_are_listed_with_what_they_are() {
    content(
        "library part \"Disk://part/part.pjx\"\nlibrary gone \"Disk://gone/gone.pjx\"\ntype Slot \"Disk://Slot/Slot.pjx\"\n\
         num nA\npublic num nB = 2.5\nbool bA\nstring sA = \"x > y\"\nstring sB\npublic num nGrid[3,4]\ndio dIn[\"\"]\n\
         point pA\npublic Slot sSlot\npart:libLoad(\"Disk://bag\")\npublic program pick(num x_n)\nbegin\nend\n\
         program place()\nbegin\nend\n--- part\npublic num nX\n--- bag\npublic num nX\n--- Slot\npublic num nX",
        expect![[r#"
            has types: true
            pick: public (num x_n); public true, runs false
            place: (); public false, runs true
            start: (); public false, runs true
            nA: num; public false, Some("0")
            nB: public num; public true, Some("2.5")
            bA: bool; public false, Some("false")
            sA: string; public false, Some("x > y")
            sB: string; public false, Some("")
            nGrid: public num[3,4]; public true, None
            dIn: dio[""]; public false, None
            pA: pointRx; public false, None
            sSlot: public Slot; public true, None
            part: Disk://part/part.pjx; Some("part"), loaded ["bag"]
            gone: Disk://gone/gone.pjx; None, loaded []
            Slot: Disk://Slot/Slot.pjx; Some("Slot"), loaded []
        "#]],
    );
}

#[test]
fn data_of_the_old_dialect_have_their_values() {
    content(
        "cls()\n=== main/main.dtx\n<dataList xmlns=\"DataNameSpace\">\n  <numSection>\n    \
         <num name=\"nA\" public=\"true\" size=\"1\">\n      <valueNum index=\"0\" value=\"7\" />\n    </num>\n    \
         <num name=\"nB\" public=\"false\" size=\"2\" />\n  </numSection>\n</dataList>",
        expect![[r#"
            has types: true
            start: (); public false, runs true
            nA: public num; public true, Some("7")
            nB: num[2]; public false, None
        "#]],
    );
}
