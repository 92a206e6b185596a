mod pages;

use expect_test::{Expect, expect};
use val3_analysis::db::FileRange;

use super::*;
use crate::testing::{MarkedListing, shown};

fn check(listing: &str, new_name: &str, expected: Expect) {
    let marked = MarkedListing::new(listing);
    let db = marked.db();
    let shown = match rename(db, marked.at(), new_name) {
        Err(error) => format!("refused: {}\n", error.0),
        Ok(change) => {
            let edits = change
                .edits
                .iter()
                .map(|edit| shown(db, FileRange { file: edit.file, range: edit.range }) + " -> " + &edit.text + "\n");
            let moves = change
                .moves
                .iter()
                .map(|(from, to)| format!("{} moves to {}\n", from.file_name().unwrap(), to.file_name().unwrap()));
            edits.chain(moves).collect()
        }
    };
    expected.assert_eq(&shown);
}

#[test]
fn variables_are_renamed() {
    check(
        "num nCount\nnCo$0unt=nCount+1",
        "nTotal",
        expect![[r#"
        main/main.dtx:4 nCount -> nTotal
        main/start.pgx:5 nCount -> nTotal
        main/start.pgx:5 nCount -> nTotal
    "#]],
    );
    check(
        "program start()\n  num l_i\nbegin\n  l_i$0=1\nend",
        "l_j",
        expect![[r#"
        main/start.pgx:5 l_i -> l_j
        main/start.pgx:8 l_i -> l_j
    "#]],
    );
}

#[test]
fn renaming_a_program_renames_its_file() {
    check(
        "call pi$0ck()\nprogram pick()\nbegin\nend",
        "grip",
        expect![[r#"
        main/main.pjx:5 pick -> grip
        main/pick.pgx:3 pick -> grip
        main/start.pgx:5 pick -> grip
        pick.pgx moves to grip.pgx
    "#]],
    );
}

/// The controller's media ignore letter case, so the element, the file and the program have the same name.
#[test]
fn a_file_and_its_entry_have_the_name_in_any_letter_case() {
    check(
        &with_pick("pick.pgx", "PICK.pgx"),
        "grab",
        expect![[r#"
        main/PICK.pgx:1 pick -> grab
        main/main.pjx:2 pick -> grab
        main/start.pgx:5 pick -> grab
        PICK.pgx moves to grab.pgx
    "#]],
    );
    check(
        &with_pick("PICK.pgx", "pick.pgx"),
        "grab",
        expect![[r#"
        main/main.pjx:2 PICK -> grab
        main/pick.pgx:1 pick -> grab
        main/start.pgx:5 pick -> grab
        pick.pgx moves to grab.pgx
    "#]],
    );
    check(
        &with_pick(".\\Pick.PGX", "PICK.pgx"),
        "grab",
        expect![[r#"
        main/PICK.pgx:1 pick -> grab
        main/main.pjx:2 Pick -> grab
        main/start.pgx:5 pick -> grab
        PICK.pgx moves to grab.pgx
    "#]],
    );
    // A file with another name than the program is not renamed.
    check(
        &with_pick("take.pgx", "take.pgx"),
        "grab",
        expect![[r#"
        main/start.pgx:5 pick -> grab
        main/take.pgx:1 pick -> grab
    "#]],
    );
}

/// A call of `pick`, which is in the file `file` and listed as `entry`.
fn with_pick(entry: &str, file: &str) -> String {
    format!(
        "call pi$0ck()\n=== main/main.pjx\n<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\"><Parameters version=\"s7.11\" /><Programs><Program file=\"start.pgx\" />\n<Program file=\"{entry}\" /></Programs></Project>\n=== main/{file}\n<Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\"><Program name=\"pick\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>\n"
    )
}

#[test]
fn every_library_of_an_interface_is_renamed() {
    check(
        "library part \"Disk://part/part.pjx\"\npart:libLoad(\"Disk://bag\")\npart:nWei$0ght=1\n--- part\npublic num nWeight\n--- bag\npublic num nWeight",
        "nMass",
        expect![[r#"
            bag/bag.dtx:4 nWeight -> nMass
            main/start.pgx:6 nWeight -> nMass
            part/part.dtx:4 nWeight -> nMass
        "#]],
    );
}

#[test]
fn names_in_strings_and_references_are_renamed() {
    let library = "library part \"Disk://part/part.pjx\"\npoint pA\n";
    check(
        &format!("{library}getData(\"part:pTr$0ack[0]\",pA)\n--- part\npublic point pTrack"),
        "pPath",
        expect![[r#"
            main/start.pgx:5 pTrack -> pPath
            part/part.dtx:4 pTrack -> pPath
        "#]],
    );
    check(
        &format!(
            "{library}if part:libExist(\"pi$0ck()\")\ncall part:pick()\nendIf\n--- part\npublic program pick()\nbegin\nend"
        ),
        "grip",
        expect![[r#"
            main/start.pgx:5 pick -> grip
            main/start.pgx:6 pick -> grip
            part/part.pjx:5 pick -> grip
            part/pick.pgx:3 pick -> grip
            pick.pgx moves to grip.pgx
        "#]],
    );
    check(
        "cls()\n=== main/main.dtx\n<Database><Datas><Data name=\"fTa$0ble\" type=\"frame\" /><Data name=\"pA\" type=\"pointRx\">\n<Value key=\"0\" fatherId=\"fTable[0]\" /></Data></Datas></Database>",
        "fBench",
        expect![[r#"
            main/main.dtx:1 fTable -> fBench
            main/main.dtx:2 fTable -> fBench
        "#]],
    );
}

#[test]
fn entries_of_the_project_file_are_renamed() {
    check(
        "library pa$0rt \"Disk://part/part.pjx\"\nput(part:nWeight)\n--- part\npublic num nWeight",
        "piece",
        expect![[r#"
            main/main.pjx:11 part -> piece
            main/start.pgx:5 part -> piece
        "#]],
    );
    check(
        "type Slot \"Disk://Slot/Slot.pjx\"\nSlot sSlot\nsSlot.nHe$0ight=1\n--- Slot\npublic num nHeight",
        "nSize",
        expect![[r#"
            Slot/Slot.dtx:4 nHeight -> nSize
            main/start.pgx:5 nHeight -> nSize
        "#]],
    );
    check(
        "type Slot \"Disk://Slot/Slot.pjx\"\nprogram start()\n  Slot l_s\nbegin\n  l_$0s.nHeight=1\nend\n--- Slot\npublic num nHeight",
        "l_slot",
        expect![[r#"
            main/start.pgx:5 l_s -> l_slot
            main/start.pgx:8 l_s -> l_slot
        "#]],
    );
}

#[test]
fn keys_of_collections_are_renamed() {
    check(
        "dio dIn[\"door\",\"lamp\"]\nwait(dIn[\"do$0or\"])\ndIn[ \"door\" ]=dIn[\"lamp\"]\nputln(\"door\")",
        "gate",
        expect![[r#"
            main/main.dtx:5 door -> gate
            main/start.pgx:5 door -> gate
            main/start.pgx:6 door -> gate
        "#]],
    );
    check(
        "frame fIn[\"door\"]\ncls()\n=== main/main.dtx\n<Database><Datas><Data name=\"fIn\" xsi:type=\"collection\" type=\"frame\">\n<Value key=\"do$0or\" /></Data><Data name=\"pA\" type=\"pointRx\">\n<Value key=\"0\" fatherId=\"fIn[&quot;door&quot;]\" /></Data></Datas></Database>",
        "gate",
        expect![[r#"
            main/main.dtx:2 door -> gate
            main/main.dtx:3 door -> gate
        "#]],
    );
    check(
        "dio dIn[\"door\",\"lamp\"]\nwait(dIn[\"do$0or\"])",
        "lamp",
        expect![[r#"
        refused: `dIn` has the key `lamp` already
    "#]],
    );
    check(
        "dio dIn[\"door\"]\nstring sKey\nwait(dIn[\"do$0or\"])\nwait(dIn[sKey])",
        "gate",
        expect![[r#"
            refused: `dIn` is also accessed with computed keys
        "#]],
    );
}

#[test]
fn a_rename_that_would_break_something_is_refused() {
    check(
        "num nA\nnum nB\nn$0A=nB",
        "nB",
        expect![[r#"
            refused: there is already data called `nB`
        "#]],
    );
    check(
        "num nA\nn$0A=1",
        "end",
        expect![[r#"
        refused: `end` is a word of the language
    "#]],
    );
    check(
        "num nA\nn$0A=1",
        "1a",
        expect![[r#"
        refused: `1a` is no name: letters, digits and `_`, no digit first
    "#]],
    );
    check(
        "num nA\nprogram start()\n  num l_i\nbegin\n  n$0A=l_i\nend",
        "l_i",
        expect![[r#"
        refused: the program `start` has a local variable called `l_i`
    "#]],
    );
    check(
        "num nA\nprogram start()\n  num l_i\nbegin\n  nA=l_$0i\nend",
        "nA",
        expect![[r#"
        refused: the program uses the global `nA`, which the new name would hide
    "#]],
    );
    check(
        "num nA\nn$0A=nB",
        "nB",
        expect![[r#"
        refused: the program `start` uses the name `nB`, which is unresolved
    "#]],
    );
    check(
        "num nA\nnA=nO$0ther",
        "nB",
        expect![[r#"
        refused: there is no name here that can be changed
    "#]],
    );
    check(
        "num nA\nnA=si$0n(1)",
        "x",
        expect![[r#"
        refused: `sin` belongs to the language
    "#]],
    );
    check(
        "num nA\nnA$0=1",
        "movej",
        expect![[r#"
            refused: `movej` is a word of the language
        "#]],
    );
    check(
        "num nA\nnA$0=1\ncall part()\nprogram part()\nbegin\nend",
        "part",
        expect![[r#"
            refused: there is already a program called `part`
        "#]],
    );
    check(
        "num nA\nprogram start()\n  num l_i\nbegin\n  l_$0i=1\nend\nprogram part()\nbegin\nend",
        "part",
        expect![[r#"
            refused: there is already a program called `part`
        "#]],
    );
    check(
        "call pi$0ck()\nprogram pick()\nbegin\nend\n=== val3.toml\n[lint]\nentry-points = [\"pick\"]",
        "grip",
        expect![[r#"
            refused: `pick` is an entry point according to `val3.toml`
        "#]],
    );
    check(
        "call oth$0er()\nprogram other()\nbegin\nend\nprogram more()\nbegin\nend",
        "More",
        expect![[r#"
            refused: there is already a program called `More`
        "#]],
    );
}

const TASKS: &str = "taskCreate \"wat$0ch\",10,other()\ntaskKill(\"watch\")\ntaskKill(\"watcher\")\nputln(\"watch\")\n\
    program other()\nbegin\n  if taskStatus( \"watch\" )!=-1\n    taskSuspend(\"watch\")\n    taskResume(\"watch\",0)\n  endIf\n@end";

#[test]
fn tasks_are_renamed_where_instructions_name_them() {
    check(
        &TASKS.replace('@', ""),
        "door",
        expect![[r#"
            main/other.pgx:5 watch -> door
            main/other.pgx:6 watch -> door
            main/other.pgx:7 watch -> door
            main/start.pgx:5 watch -> door
            main/start.pgx:6 watch -> door
        "#]],
    );
}

#[test]
fn tasks_keep_names_that_are_taken_or_computed() {
    let refused = |line: &str, name: &str, expected: Expect| check(&TASKS.replace('@', line), name, expected);
    refused(
        "",
        "watcher",
        expect![[r#"
        refused: there is already a task called `watcher`
    "#]],
    );
    refused(
        "",
        "",
        expect![[r#"
        refused: a task has a name: letters, digits and `_`
    "#]],
    );
    refused(
        "",
        "a b",
        expect![[r#"
        refused: `a b` is no name of a task: letters, digits and `_`
    "#]],
    );
    refused(
        "",
        "watchOfTheDoors1",
        expect![[r#"
        refused: names of tasks have at most 15 characters in this version
    "#]],
    );
    refused(
        "taskKill(\"wat\"+toString(\"\",1))\n",
        "door",
        expect![[r#"
        refused: the program `other` computes the name of a task, which may be `watch`
    "#]],
    );
    refused(
        "taskKill(\"do\"+toString(\"\",1))\n",
        "door",
        expect![[r#"
        refused: the program `other` computes the name of a task, which may be `door`
    "#]],
    );
}

#[test]
fn tasks_in_escaped_code_are_renamed() {
    let program = "<Programs><Program name=\"other\"><Code>begin\n  taskKill(&quot;wa$0tch&quot;)\nend</Code></Program></Programs>";
    check(
        &format!("taskCreate \"watch\",10,other()\n=== main/other.pgx\n{program}"),
        "1",
        expect![[r#"
            main/other.pgx:2 watch -> 1
            main/start.pgx:5 watch -> 1
        "#]],
    );
}
