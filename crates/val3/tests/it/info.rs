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
    check(
        &palletiser(),
        &["cell"],
        0,
        expect![[r#"
        cell
          serial number   unknown
          software        s7.11.3
          arm             tx90l-S1, floor
          simulation      emulation
          language        english
          starts with     palletiser

        Applications
          io            0 programs    2 files     2.4 kB
          palletiser   23 programs   25 files    29.3 kB
          partBag       4 programs    6 files     4.6 kB
          partBox       4 programs    6 files     4.2 kB
          Slot          0 programs    2 files      865 B

        Boards and signals
          BasicIO-1: 16 inputs, 16 outputs
          ModbusSrv-0: 2 signals: Modbus-Word\Vacuum, Modbus-Word\Weight
          Socket: 1 signal: host
          bio2: not in the controller
          mio: not in the controller
          cio: not in the controller

        Users
          operator: readAccess; not writeAccess

        Missing for val3 run
          nothing
    "#]],
    );
}

#[test]
fn missing_and_damaged_parts_are_named() {
    let folder = palletiser();
    std::fs::remove_file(folder.path().join("cell/usr/usrapp/palletiser/start.pgx")).unwrap();
    folder.write("cell/usr/configs/arm.cfx", "<arm");
    check(
        &folder,
        &["cell"],
        2,
        expect![[r#"
        cell
          serial number   unknown
          software        s7.11.3
          arm             unknown
          simulation      emulation
          language        english
          starts with     palletiser

        Applications
          io            0 programs    2 files     2.4 kB
          palletiser   22 programs   24 files    28.9 kB
          partBag       4 programs    6 files     4.6 kB
          partBox       4 programs    6 files     4.2 kB
          Slot          0 programs    2 files      865 B

        Boards and signals
          BasicIO-1: 16 inputs, 16 outputs
          ModbusSrv-0: 2 signals: Modbus-Word\Vacuum, Modbus-Word\Weight
          Socket: 1 signal: host
          bio2: not in the controller
          mio: not in the controller
          cio: not in the controller

        Users
          operator: readAccess; not writeAccess

        Not read
          cell/usr/configs/arm.cfx: line 1: an element is not closed; the file is cut off or damaged

        Missing for val3 run
          the arm is unknown: name it with --arm
          cell/tests/faultsTest/faultsTest.pjx:2: the file `usr/configs/arm.cfx` of the cell cannot be read: line 1: an element is not closed; the file is cut off or damaged; copy the file from the controller again, or delete it if the controller does not have it
          cell/usr/usrapp/palletiser/palletiser.pjx:22: the program file `start.pgx` is not on the disk; copy the file into the folder of the project, or remove the entry
    "#]],
    );
}

#[test]
fn the_document_lists_signals() {
    let folder = palletiser();
    let run = folder.val3(&["info", "cell", "--format", "json"]);
    let document: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    let controller = &document["controllers"][0];
    assert_eq!((document["version"].as_u64(), controller["unread"].as_array().map(Vec::len)), (Some(1), Some(0)));
    let board = controller["devices"].as_array().unwrap().iter().find(|device| device["name"] == "BasicIO-1").unwrap();
    expect![[r#"{"direction":"input","link":"BasicIO-1\\%I0","name":"bIn0","type":"dio"}"#]]
        .assert_eq(&board["signals"][0].to_string());
    expect![[r#"[{"denied":["writeAccess"],"is_default":false,"name":"operator","rights":["readAccess"]}]"#]]
        .assert_eq(&controller["users"].to_string());
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
