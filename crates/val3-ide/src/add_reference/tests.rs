//! Adding libraries and types to projects of both dialects.

use expect_test::{Expect, expect};
use salsa::Setter as _;
use val3_analysis::db::Sources;

use super::ReferenceKind::{Library, Type};
use super::*;
use crate::testing::MarkedListing;

fn project(db: &dyn Db, name: &str) -> Project {
    let projects = Sources::get(db).projects(db).values();
    *projects.into_iter().find(|project| file_stem(db, **project) == name).unwrap()
}

fn file_stem(db: &dyn Db, project: Project) -> &str {
    project.manifest(db).path(db).file_stem().unwrap()
}

const CELL: &str = "library part \"Disk://part/part.pjx\"\ntype Slot \"Disk://types/Slot/Slot.pjx\"\nnum bag\n\
    put(part:nWeight)\n--- part\nlibrary tray \"Disk://tray/tray.pjx\"\npublic num nWeight\n--- bag\n\
    public num nWeight\npublic program pick()\nbegin\nend\n--- tray\nlibrary main \"Disk://main/main.pjx\"\n\
    --- types/Slot\npublic num nHeight\n--- types/Stack\ntype Slot \"Disk://types/Slot/Slot.pjx\"\npublic Slot sSlot";

fn candidates(listing: &str, of: &str, expected: Expect) {
    let marked = MarkedListing::new(listing);
    let db = marked.db();
    let lines: String = reference_candidates(db, project(db, of)).into_iter().map(line).collect();
    expected.assert_eq(&lines);
}

fn line(candidate: ReferenceCandidate) -> String {
    let ReferenceCandidate { name, path, present, programs, data, fits, library_circle, type_circle, .. } = candidate;
    let circles = format!("circles {library_circle} {type_circle}");
    format!("{name} {path}: {programs} programs, {data} data, {present:?}, fits {fits:?}, {circles}\n")
}

#[test]
fn the_projects_of_the_cell_are_candidates() {
    candidates(
        CELL,
        "main",
        expect![[r#"
        bag2 Disk://bag/bag.pjx: 1 programs, 1 data, [], fits ["part"], circles false false
        part2 Disk://part/part.pjx: 0 programs, 1 data, [(Library, "part")], fits [], circles true false
        tray Disk://tray/tray.pjx: 0 programs, 0 data, [], fits [], circles true false
        Slot2 Disk://types/Slot/Slot.pjx: 0 programs, 1 data, [(Type, "Slot")], fits [], circles false false
        Stack Disk://types/Stack/Stack.pjx: 0 programs, 1 data, [], fits [], circles false false
    "#]],
    );
    candidates(
        CELL,
        "Slot",
        expect![[r#"
        bag Disk://bag/bag.pjx: 1 programs, 1 data, [], fits [], circles false false
        main Disk://main/main.pjx: 0 programs, 0 data, [], fits [], circles false true
        part Disk://part/part.pjx: 0 programs, 1 data, [], fits [], circles false false
        tray Disk://tray/tray.pjx: 0 programs, 0 data, [], fits [], circles false false
        Stack Disk://types/Stack/Stack.pjx: 0 programs, 1 data, [], fits [], circles false true
    "#]],
    );
}

#[test]
fn names_are_free_and_short_enough() {
    candidates(
        "cls()\nversion s7.3\nnum partOfACell\n--- part-of-a-cell\npublic num nA\n--- aVeryLongLibraryName\npublic num nA\n--- 2nd\npublic num nA",
        "main",
        expect![[r#"
            _2nd Disk://2nd/2nd.pjx: 0 programs, 1 data, [], fits [], circles false false
            aVeryLongLibrar Disk://aVeryLongLibraryName/aVeryLongLibraryName.pjx: 0 programs, 1 data, [], fits [], circles false false
            part_of_a_cell Disk://part-of-a-cell/part-of-a-cell.pjx: 0 programs, 1 data, [], fits [], circles false false
        "#]],
    );
}

const OLD: &str = "<?xml version=\"1.0\" encoding=\"utf-8\" ?>\r\n<project xmlns=\"ProjectNameSpace\" >\r\n  \
    <parameters version=\"s6.8\" stackSize=\"5000\" millimeterUnit=\"true\" />\r\n  <programSection>\r\n    \
    <program file=\"start.pgx\" />\r\n  </programSection>\r\n  <dataSection>\r\n    <data file=\"main.dtx\" />\r\n  \
    </dataSection>\r\n  <aliasSection>\r\n    <alias name=\"io\" interface=\"io\" autoload=\"true\" password=\"\" />\r\n  \
    </aliasSection>\r\n</project>\r\n";

const NEW: &str = "\u{feff}<?xml version=\"1.0\" encoding=\"utf-8\" ?>\n<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\">\n\
    \t<Parameters version=\"s7.8.3\" stackSize=\"5000\" millimeterUnit=\"true\" />\n\t<Programs />\n\t<Database>\n\
    \t\t<Data file=\"main.dtx\" />\n\t</Database>\n\t<Libraries>\n\t</Libraries>\n</Project>";

const OTHERS: &str = "--- part\npublic num nA\n--- io\npublic num nA";

/// Project file after the addition, or the error message.
fn added(manifest: &str, kind: ReferenceKind, name: &str, path: &str) -> String {
    let mut db = MarkedListing::new(&format!("cls()\n{OTHERS}")).workspace.db;
    // The text is set directly, because a listing would change its line ends.
    let file = project(&db, "main").manifest(&db);
    file.set_text(&mut db).to(manifest.into());
    let db = &db;
    match add_reference(db, project(db, "main"), kind, name, path) {
        Ok(change) => {
            let [edit] = change.edits.as_slice() else { panic!("{change:?}") };
            let mut text = edit.file.text(db).to_string();
            text.replace_range(std::ops::Range::<usize>::from(edit.range), &edit.text);
            text
        }
        Err(RefactoringError(reason)) => reason,
    }
}

#[test]
fn a_library_of_s6_is_added_byte_for_byte() {
    let last = "autoload=\"true\" password=\"\" />\r\n";
    let expected = OLD.replace(last, &format!("{last}    <alias name=\"part\" interface=\"part\" />\r\n"));
    assert_eq!(added(OLD, Library, "part", "part"), expected);
    assert_eq!(added(OLD, Type, "Part", "part"), "projects of s5 and s6 have no user types");
}

#[test]
fn a_library_of_s7_is_added_byte_for_byte() {
    let library = "\t<Libraries>\n\t  <Library alias=\"part\" path=\"Disk://part/part.pjx\" />\n";
    let expected = NEW.replace("\t<Libraries>\n", library);
    assert_eq!(added(NEW, Library, "part", "Disk://part/part.pjx"), expected);
}

#[test]
fn the_first_type_gets_a_list() {
    let ty = "\t</Libraries>\n\t<Types>\n\t  <Type name=\"Part\" path=\"Disk://part/part.pjx\" />\n\t</Types>\n";
    assert_eq!(added(NEW, Type, "Part", "Disk://part/part.pjx"), NEW.replace("\t</Libraries>\n", ty));
}

#[test]
fn what_cannot_be_added_has_a_reason() {
    assert_eq!(
        added(NEW, Library, "1st", "Disk://part/part.pjx"),
        "`1st` is no name: letters, digits and `_`, no digit first"
    );
    assert_eq!(added(OLD, Library, "io", "part"), "there is already a library identifier called `io`");
    assert_eq!(added(NEW, Library, "part", "Disk://gone/gone.pjx"), "there is no project at `Disk://gone/gone.pjx`");
    let itself = "the project would use itself: `Disk://main/main.pjx` uses it, directly or through others";
    assert_eq!(added(NEW, Library, "part", "Disk://main/main.pjx"), itself);
    let broken = NEW.replace("</Libraries>", "</Librari");
    let reason = "`main.pjx` has errors. Correct them first, so that nothing else changes";
    assert_eq!(added(&broken, Library, "part", "Disk://part/part.pjx"), reason);
}
