//! Files in a checked folder that belong to no application: each is checked or reported.

use std::collections::BTreeSet;
use std::fs;

use proptest::prelude::*;
use serde_json::Value;

use crate::archives::pack;
use crate::support::{CLEAN, CommandOutput, Folder};

/// An s7 program with this name and code.
fn program(name: &str, code: &str) -> String {
    format!(
        "<Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\"><Program name=\"{name}\"><Code><![CDATA[begin\n\
         {code}\nend]]></Code></Program></Programs>"
    )
}

const DATA: &str = "<Database xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\"><Datas/></Database>";

#[test]
fn a_program_without_a_project_is_checked_for_what_needs_none() {
    let application = Folder::with(
        "--- main\nnum nCount\nprogram start()\nbegin\n  nCount=nOther+1\n  call other(pPick)\n  part:open()\nend\n",
    );
    let folder = Folder::empty();
    let program = application.read("usrapp/main/start.pgx");
    folder.write("start.pgx", &program);
    for path in ["start.pgx", "."] {
        let run = folder.val3(&["check", path, "--format", "concise"]);
        let note = "start.pgx:1:1: info[V0543] `start.pgx` has no project (`.pjx`) in its folder: names and types that a \
                    project declares are not checked\n";
        assert_eq!((run.code, run.stdout.as_str()), (0, note), "{run:?}");
        assert!(run.stderr.contains("1 info in 1 of 1 file (0 applications, "), "{run:?}");
    }
    folder.write("start.pgx", &program.replace("nCount=nOther+1", "nCount=left(1,2)\n  nCount=(1"));
    for path in ["start.pgx", "."] {
        let run = folder.val3(&["check", path, "--format", "concise"]);
        assert_eq!(run.code, 1, "{run:?}");
        assert!(run.stdout.lines().count() == 3 && !run.stdout.contains(".pjx:"), "{run:?}");
    }
    folder.write("start.pgx", "");
    assert_eq!(folder.val3(&["check", "start.pgx"]).code, 2);
    assert_eq!(folder.val3(&["check"]).code, 2);
}

#[test]
fn a_data_file_without_a_project_is_checked_for_what_needs_none() {
    let folder = Folder::with("num nCount = 1\nnCount=1\n");
    let data = folder.read("usrapp/main/main.dtx");
    let alone = Folder::empty();
    alone.write("old/main.dtx", &data.replace("\"num\"", "\"nmu\""));
    for path in ["old/main.dtx", "."] {
        let run = alone.val3(&["check", path, "--format", "concise"]);
        assert_eq!(run.code, 0, "an unknown type may be one of the project: {run:?}");
        assert!(run.stdout.contains("info[V0543] `main.dtx` has no project"), "{run:?}");
    }
    alone.write("old/main.dtx", &data.replace("</Database>", ""));
    assert_eq!(alone.val3(&["check", "."]).code, 1);
}

#[test]
fn files_of_the_old_dialect_need_no_project_either() {
    let folder = Folder::empty();
    let code = "begin\n  nCount=(1\nend";
    folder.write(
        "start.pgx",
        &format!("<programList><program name=\"start\"><source><code>{code}</code></source></program></programList>"),
    );
    folder.write("main.dtx", "<dataList></dataList>");
    let run = folder.val3(&["check", "--format", "concise"]);
    assert_eq!(run.code, 1, "{run:?}");
    let codes: Vec<&str> = run.stdout.lines().filter_map(|line| line.split(['[', ']']).nth(1)).collect();
    assert_eq!(codes.iter().filter(|code| **code == "V0543").count(), 2, "{run:?}");
    assert!(!codes.contains(&"V0503"), "{run:?}");
}

#[test]
fn limits_of_versions_are_not_applied_to_a_program_that_names_none() {
    let folder = Folder::empty();
    let code = "  taskCreate \"aTaskWithALongName\",10,workOnEverything()";
    folder.write("start.pgx", &program("start", code));
    let run = folder.val3(&["check", "--format", "concise"]);
    assert_eq!((run.code, run.stdout.lines().count()), (0, 1), "{run:?}");
}

#[test]
fn the_project_that_stands_for_a_missing_one_is_in_no_answer() {
    let folder = Folder::empty();
    folder.write("start.pgx", &program("start", "nCount=(1"));
    folder.write("start.dtx", DATA);
    for format in FORMATS {
        let run = folder.val3(&["check", "--format", format]);
        assert!(!run.stdout.contains("pgx.pjx") && !run.stdout.contains("dtx.pjx"), "{run:?}");
    }
    let run = folder.val3(&["check", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!((&report["summary"]["applications"], &report["summary"]["files"]), (&0.into(), &2.into()), "{run:?}");
    assert_eq!(report["diagnostics"][0]["application"], "start.dtx");
    let fixed = folder.val3(&["check", "--fix"]);
    assert!(!folder.path().join("start.pgx.pjx").exists(), "{fixed:?}");
}

const FORMATS: [&str; 12] = [
    "human",
    "concise",
    "json",
    "json-lines",
    "val3check",
    "sarif",
    "github",
    "gitlab",
    "azure",
    "junit",
    "checkstyle",
    "rdjson",
];

/// A folder with an application, a backup archive and a program without a project.
fn mixed() -> Folder {
    let folder = Folder::with(CLEAN);
    pack(&Folder::with(CLEAN), &folder.path().join("backup.zip"));
    folder.write("old/cycle.pgx", &program("cycle", "wait(true)"));
    folder
}

#[test]
fn every_format_names_what_was_not_read_or_not_checked_whole() {
    let folder = mixed();
    for format in FORMATS {
        let run = folder.val3(&["check", "--format", format]);
        assert_eq!(run.code, 0, "{run:?}");
        assert!(
            run.stdout.contains("the archive `backup.zip` is not read: it contains a project"),
            "{format}: {run:?}"
        );
        assert!(run.stdout.contains("`cycle.pgx` has no project"), "{format}: {run:?}");
    }
}

#[test]
fn a_rule_that_is_off_and_an_excluded_folder_say_nothing() {
    let folder = mixed();
    assert_quiet(&folder.val3(&["check", "--ignore", "V0543,V0544"]));
    folder.write("val3.toml", "[rules]\nV0543 = \"off\"\narchive-not-read = \"off\"\n");
    assert_quiet(&folder.val3(&["check"]));
    folder.write("val3.toml", "exclude = [\"old/**\", \"*.zip\"]\n");
    assert_quiet(&folder.val3(&["check"]));
    assert!(folder.val3(&["check", "old"]).stdout.contains("V0543"));
    folder.write("val3.toml", "[rules]\nV0544 = \"error\"\n");
    assert_eq!(folder.val3(&["check"]).code, 1);
}

fn assert_quiet(run: &CommandOutput) {
    assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{run:?}");
    assert!(run.stderr.contains("no findings"), "{run:?}");
}

#[test]
fn an_archive_in_a_requested_archive_is_named() {
    let folder = Folder::empty();
    let inner = Folder::with(CLEAN);
    pack(&Folder::with(CLEAN), &inner.path().join("inner.zip"));
    pack(&inner, &folder.path().join("outer.zip"));
    let run = folder.val3(&["check", "outer.zip"]);
    assert!(run.stdout.contains("the archive `inner.zip` is not read: it is in another archive"), "{run:?}");
}

#[test]
fn a_folder_that_is_too_deep_is_named() {
    let folder = Folder::with(CLEAN);
    folder.write(&format!("{}start.pgx", "a/".repeat(34)), &program("start", "wait(true)"));
    let run = folder.val3(&["check"]);
    assert_eq!(run.code, 2, "{run:?}");
    assert!(run.stderr.contains("more than 32 folders deep"), "{run:?}");
}

/// A kind of file in the generated folders.
#[derive(Debug, Clone, Copy)]
enum Kind {
    Application,
    Listed,
    Program,
    Data,
    Backup,
    OtherArchive,
    DamagedArchive,
    Text,
}

fn kinds() -> impl Strategy<Value = Kind> {
    prop::sample::select(vec![
        Kind::Application,
        Kind::Listed,
        Kind::Program,
        Kind::Data,
        Kind::Backup,
        Kind::OtherArchive,
        Kind::DamagedArchive,
        Kind::Text,
    ])
}

/// Writes a file, or the files of an application, into a folder. `number` is part of all names.
fn write(folder: &Folder, below: &str, number: usize, kind: Kind) {
    let path = |extension: &str| format!("{below}/f{number}.{extension}");
    match kind {
        Kind::Application | Kind::Listed => {
            let listed = if matches!(kind, Kind::Listed) {
                format!("<Program file=\"f{number}.pgx\" />")
            } else {
                String::new()
            };
            let project = format!(
                "<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\"><Parameters version=\"s7.11\" \
                 stackSize=\"5000\" millimeterUnit=\"true\" /><Programs>{listed}</Programs><Database/></Project>"
            );
            folder.write(&path("pjx"), &project);
            folder.write(&path("PGX"), &program(&format!("f{number}"), "wait(true)"));
        }
        Kind::Program => folder.write(&path("pgx"), &program(&format!("f{number}"), "wait(true)")),
        Kind::Data => folder.write(&path("dtx"), DATA),
        Kind::Backup | Kind::OtherArchive => {
            let content = Folder::empty();
            let inner = if matches!(kind, Kind::Backup) { "main/start.pgx" } else { "notes.txt" };
            content.write(inner, "text");
            fs::create_dir_all(folder.path().join(below)).unwrap();
            pack(&content, &folder.path().join(path("zip")));
        }
        Kind::DamagedArchive => folder.write(&path("zip"), "no archive"),
        Kind::Text => folder.write(&path("txt"), "text"),
    }
}

/// Number of files with a VAL 3 extension, and of archives that contain such files or cannot be read.
fn accountable(kind: Kind) -> usize {
    match kind {
        Kind::Application | Kind::Listed => 2,
        Kind::Program | Kind::Data | Kind::Backup | Kind::DamagedArchive => 1,
        Kind::OtherArchive | Kind::Text => 0,
    }
}

/// Whether a check finds something to read.
fn is_checked(kind: Kind) -> bool {
    !matches!(kind, Kind::Backup | Kind::OtherArchive | Kind::DamagedArchive | Kind::Text)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn every_file_is_counted_as_read_or_named(
        files in prop::collection::vec((prop::sample::select(vec!["a", "a/b", "c.d"]), kinds()), 1..12)
    ) {
        let folder = Folder::empty();
        for (number, (below, kind)) in files.iter().enumerate() {
            write(&folder, below, number, *kind);
        }
        let run = folder.val3(&["check", "--format", "json"]);
        if !files.iter().any(|(_, kind)| is_checked(*kind)) {
            prop_assert_eq!(run.code, 2);
            let has_backup = files.iter().any(|(_, kind)| matches!(kind, Kind::Backup | Kind::DamagedArchive));
            prop_assert_eq!(run.stderr.contains(".zip"), has_backup);
            return Ok(());
        }
        let report: Value = serde_json::from_str(&run.stdout).unwrap();
        let counted = report["summary"]["files"].as_u64().unwrap() as usize;
        let messages = report["diagnostics"].as_array().unwrap().iter().filter(|it| it["code"] == "V0531" || it["code"] == "V0544");
        let named: BTreeSet<&str> = messages.map(|it| it["message"].as_str().unwrap()).collect();
        let all: usize = files.iter().map(|(_, kind)| accountable(*kind)).sum();
        prop_assert_eq!(counted + named.len(), all, "{:?}", run);
    }
}
