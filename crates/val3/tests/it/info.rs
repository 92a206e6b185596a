//! `val3 info`.

use std::path::Path;

use expect_test::{Expect, expect};

use crate::support::{Folder, copy_folder};

/// The palletiser with a user, in a folder of its own.
fn palletiser() -> Folder {
    let folder = Folder::empty();
    copy_folder(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/palletiser"), &folder.path().join("cell"));
    folder.write(
        "cell/usr/configs/profiles/operator.cfx",
        "<Profile><Password name=\"password\" value=\"c0ffee\"/><Bool name=\"readAccess\" value=\"true\"/>\
         <Bool name=\"writeAccess\" value=\"false\"/></Profile>",
    );
    folder
}

/// Output without the dates of the copied files.
#[track_caller]
fn check(folder: &Folder, arguments: &[&str], code: i32, expected: Expect) {
    let run = folder.val3(&[&["info"], arguments].concat());
    assert_eq!(run.code, code, "{run:?}");
    let date = |line: &str| match line.split_once("B  20") {
        Some((before, _)) => format!("{before}B\n"),
        None => format!("{line}\n"),
    };
    expected.assert_eq(&run.stdout.lines().map(date).collect::<String>());
    assert!(!run.stdout.contains("c0ffee"), "{run:?}");
}

#[test]
fn a_cell_is_described() {
    check(&palletiser(), &["cell"], 0, expect![[r#""#]]);
}

#[test]
fn missing_and_damaged_parts_are_named() {
    let folder = palletiser();
    std::fs::remove_file(folder.path().join("cell/usr/usrapp/palletiser/start.pgx")).unwrap();
    folder.write("cell/usr/configs/arm.cfx", "<arm");
    check(&folder, &["cell"], 2, expect![[r#""#]]);
}

#[test]
fn the_document_lists_signals() {
    let folder = palletiser();
    let run = folder.val3(&["info", "cell", "--format", "json"]);
    let document: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    let controller = &document["controllers"][0];
    assert_eq!((document["version"].as_u64(), controller["unread"].as_array().map(Vec::len)), (Some(1), Some(0)));
    let board = controller["devices"].as_array().unwrap().iter().find(|device| device["name"] == "BasicIO-1").unwrap();
    expect![[r#""#]].assert_eq(&board["signals"][0].to_string());
    expect![[r#""#]].assert_eq(&controller["users"].to_string());
}

#[test]
fn an_archive_is_described() {
    let folder = Folder::empty();
    crate::archives::pack(&Folder::with("cls()\n"), &folder.path().join("backup.zip"));
    let run = folder.val3(&["info", "backup.zip"]);
    assert!(run.code == 0 && run.stdout.contains("main") && run.stdout.contains("the arm is unknown"), "{run:?}");
}

#[test]
fn other_folders_are_refused() {
    let folder = Folder::empty();
    folder.write("a/readme.txt", "");
    for (path, message) in [
        ("a", "contains neither applications nor settings"),
        ("a/readme.txt", "neither a folder nor a zip"),
        ("b", "does not exist"),
    ] {
        let run = folder.val3(&["info", path]);
        assert!(run.code == 2 && run.stderr.contains(message), "{path}: {run:?}");
    }
}
