//! `val3 pull` from wrong places, and with conflicts that cannot be merged: local files are kept.

use std::fs;

use expect_test::expect;

use crate::controller::{in_cell, program, pulled};
use crate::support::{CommandOutput, Folder};

const START: &str = "usr/usrapp/demo/start.pgx";
const ARCHIVE: &str = "usr/usrapp/demo/lib.zip";

/// A pull that must change no local file.
#[track_caller]
fn refused(folder: &Folder, args: &[&str], code: i32) -> String {
    let state = folder.read("cell/.val3/controller.toml");
    let run = in_cell(folder, &[&["pull"], args].concat());
    assert_eq!(run.code, code, "{}", run.stderr);
    let names = ["demo.pjx", "demo.dtx", "start.pgx", "stop.pgx"];
    assert!(names.iter().all(|name| folder.path().join("cell/usr/usrapp/demo").join(name).exists()));
    assert_eq!(folder.read("cell/.val3/controller.toml"), state);
    run.stderr
}

/// A pull that must succeed with this exit code.
#[track_caller]
fn done(folder: &Folder, args: &[&str], code: i32) -> CommandOutput {
    let run = in_cell(folder, &[&["pull"], args].concat());
    assert_eq!(run.code, code, "{}", run.stderr);
    run
}

#[test]
fn a_place_without_applications_removes_nothing() {
    let folder = pulled();
    fs::create_dir_all(folder.path().join("empty")).unwrap();
    expect![[r#"
        error: there is no folder `usr/usrapp` at …/robot/usr
          help: name the folder that contains `usr`, or the root of the server
    "#]]
    .assert_eq(&refused(&folder, &["../robot/usr"], 2));
    assert!(refused(&folder, &["../empty"], 2).contains("there is no folder `usr/usrapp` at …/empty"));
    let first = folder.val3(&["pull", "empty", "new"]);
    assert!(first.code == 2 && !folder.path().join("new").exists(), "{}", first.stderr);
    fs::rename(folder.path().join("robot/usr/usrapp"), folder.path().join("robot/usr/old")).unwrap();
    refused(&folder, &[], 2);
    assert_eq!(in_cell(&folder, &["status"]).code, 2);
}

#[test]
fn a_removed_application_needs_a_confirmation() {
    let folder = pulled();
    fs::remove_dir_all(folder.path().join("robot/usr/usrapp/demo")).unwrap();
    expect![[r#"
        …/robot: controller F10-1
        error: the controller no longer has any files in `usr/usrapp/demo` (4 here), so the pull would remove all of them here
          help: if they were removed on the controller on purpose, add --accept-removals; else check the address and the rights of the profile
    "#]]
    .assert_eq(&refused(&folder, &[], 2));
    let run = done(&folder, &["--accept-removals"], 0);
    expect![[r#"
        …/robot: controller F10-1
        removed here, because the controller no longer has them: `usr/usrapp/demo/demo.dtx`, `usr/usrapp/demo/demo.pjx`, `usr/usrapp/demo/start.pgx`, `usr/usrapp/demo/stop.pgx`
        .: 0 files of the controller (0 bytes), 0 updated, 4 removed here
    "#]]
    .assert_eq(&run.stderr);
    assert!(!folder.path().join("cell/usr/usrapp/demo").exists());
}

#[test]
fn an_emulator_without_a_serial_number_is_recognised_by_its_address() {
    let folder = Folder::empty();
    for robot in ["robot", "other"] {
        folder.write(&format!("{robot}/usr/usrapp/demo/start.pgx"), &program("start", robot));
    }
    assert_eq!(folder.val3(&["pull", "robot", "cell"]).code, 0);
    let before = folder.read("cell/.val3/controller.toml");
    let run = in_cell(&folder, &["pull", "../other"]);
    assert_eq!(run.code, 2);
    expect![[r#"
        error: the controller has no serial number by which it could be identified, and at the last pull the address was `…/robot`
          help: if this project belongs to the controller at the new address, add --new-controller; else pull into a new folder
    "#]]
    .assert_eq(&run.stderr);
    assert_eq!(folder.read("cell/.val3/controller.toml"), before);
    done(&folder, &["../other", "--new-controller"], 0);
    assert!(folder.read(&format!("cell/{START}")).contains("other"));
    done(&folder, &[], 0);
}

#[test]
fn a_wrong_name_of_an_application_has_a_proposal() {
    let folder = pulled();
    for (name, help) in [("Demo", "did you mean `demo`?"), ("palletiser", "its applications are in `demo`")] {
        assert!(refused(&folder, &["--app", name], 2).contains(help));
        let first = folder.val3(&["pull", "robot", "new", "--app", name]);
        assert!(
            first.code == 2 && first.stderr.contains(&format!("no files in `usr/usrapp/{name}`")),
            "{}",
            first.stderr
        );
        assert!(!folder.path().join("new/.val3/controller.toml").exists());
    }
}

#[test]
fn a_file_that_is_no_text_keeps_both_versions() {
    let folder = pulled();
    let write = |side: &str, bytes: &[u8]| fs::write(folder.path().join(side).join(ARCHIVE), bytes).unwrap();
    write("robot", b"PK\x03\x04 old");
    done(&folder, &[], 0);
    let [mine, theirs] = [&b"PK\x03\x04 mine \xff"[..], b"PK\x03\x04 theirs \xfe"];
    write("cell", mine);
    write("robot", theirs);
    folder.write("robot/usr/usrapp/demo/stop.pgx", &program("stop", "nCount=9"));
    let run = done(&folder, &["--merge"], 1);
    expect![[r#"
        …/robot: controller F10-1
        usr/usrapp/demo/lib.zip: not merged, both versions are kept: only data, programs, projects and settings are merged
        help: `val3 pull --print PATH` prints the controller's version; decide with `val3 pull --keep-local PATH`, or with `val3 pull --keep-controller PATH`
        .: 5 files of the controller (1111 bytes), 1 updated, 1 with a conflict left
    "#]]
    .assert_eq(&run.stderr);
    let local = || fs::read(folder.path().join("cell").join(ARCHIVE)).unwrap();
    assert_eq!(local(), mine);
    assert!(in_cell(&folder, &["status"]).stdout.contains("conflict    usr/usrapp/demo/lib.zip"));
    assert_eq!(in_cell(&folder, &["push", "--unloaded", "--ignore", "V"]).code, 1);
    assert_eq!(fs::read(folder.path().join("robot").join(ARCHIVE)).unwrap(), theirs);
    done(&folder, &["--keep-controller", ARCHIVE], 0);
    assert_eq!(local(), theirs);
    write("cell", mine);
    write("robot", b"PK\x03\x04 new");
    assert!(refused(&folder, &["--keep-local", START], 2).contains("no file has changed on both sides"));
    done(&folder, &["--keep-local", ARCHIVE], 0);
    assert_eq!(local(), mine);
    assert_eq!(in_cell(&folder, &["status"]).stdout, "local       usr/usrapp/demo/lib.zip: changed\n");
}

#[test]
fn texts_that_are_not_merged_stay_conflicts() {
    let utf16 = |text: &str| [&b"\xff\xfe"[..], &text.bytes().flat_map(|byte| [byte, 0]).collect::<Vec<_>>()].concat();
    for (name, old, mine, theirs) in [
        ("recipe.txt", utf16("old"), utf16("mine"), utf16("theirs")),
        ("recipe.csv", b"1;2\n".to_vec(), b"1;3\n".to_vec(), b"1;4\n".to_vec()),
        ("data.dtx", utf16("<a/>"), utf16("<b/>"), utf16("<c/>")),
        ("recipe.xml", b"<a v=\"1\"/>".to_vec(), b"<a v=\"2\"/>".to_vec(), b"<a v=\"3\"/>".to_vec()),
        ("cell.cfx", b"<a v=\"1\"/>".to_vec(), b"<a v=\"2\"".to_vec(), b"<a v=\"3\"/>".to_vec()),
    ] {
        let folder = pulled();
        let path = |side: &str| folder.path().join(side).join("usr/usrapp/demo").join(name);
        fs::write(path("robot"), old).unwrap();
        done(&folder, &[], 0);
        fs::write(path("cell"), &mine).unwrap();
        fs::write(path("robot"), &theirs).unwrap();
        let run = done(&folder, &["--merge"], 1);
        assert!(
            run.stderr.contains("both versions are kept") && run.stderr.contains("0 updated, 1 with"),
            "{}",
            run.stderr
        );
        assert_eq!((fs::read(path("cell")).unwrap(), fs::read(path("robot")).unwrap()), (mine, theirs));
        assert!(in_cell(&folder, &["status"]).stdout.starts_with("conflict"), "{name}");
        assert_eq!(in_cell(&folder, &["push", "--unloaded", "--ignore", "V"]).code, 1, "{name}");
    }
}

#[test]
fn settings_with_a_conflict_do_not_claim_that_the_check_finds_it() {
    let folder = pulled();
    let settings = |value: &str| format!("<a>\n  <b name=\"x\" v=\"{value}\" />\n</a>\n");
    for (side, value) in [("robot", "1"), ("cell", "2"), ("robot", "3")] {
        folder.write(&format!("{side}/usr/usrapp/demo/cell.cfx"), &settings(value));
        if value == "1" {
            done(&folder, &[], 0);
        }
    }
    let run = done(&folder, &["--merge"], 1);
    assert!(run.stderr.contains("1 conflict; search the file for `<<<<<<<`"), "{}", run.stderr);
    assert!(folder.read("cell/usr/usrapp/demo/cell.cfx").contains("<<<<<<<"));
}

#[test]
fn a_file_and_a_folder_change_places() {
    let folder = pulled();
    let inner = format!("{START}/inner.pgx");
    fs::remove_file(folder.path().join("robot").join(START)).unwrap();
    folder.write(&format!("robot/{inner}"), "inner");
    done(&folder, &[], 0);
    assert_eq!(folder.read(&format!("cell/{inner}")), "inner");
    fs::remove_dir_all(folder.path().join("robot").join(START)).unwrap();
    folder.write(&format!("robot/{START}"), "start");
    done(&folder, &[], 0);
    assert_eq!(folder.read(&format!("cell/{START}")), "start");
    fs::remove_file(folder.path().join("robot").join(START)).unwrap();
    folder.write(&format!("robot/{inner}"), "inner");
    folder.write(&format!("cell/{START}"), "mine");
    assert!(refused(&folder, &["--merge"], 2).contains("because `usr/usrapp/demo/start.pgx` exists"));
}

#[test]
fn a_damaged_state_has_a_remedy() {
    let folder = pulled();
    let state = folder.read("cell/.val3/controller.toml");
    folder.write("cell/.val3/controller.toml", &format!("<<<<<<< ours\n{state}"));
    for command in ["pull", "status", "push"] {
        let run = in_cell(&folder, &[command]);
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains("line 1: ") && run.stderr.contains("restore the file"), "{}", run.stderr);
    }
    let usr = folder.read(&format!("cell/{START}"));
    fs::remove_file(folder.path().join("cell/.val3/controller.toml")).unwrap();
    done(&folder, &["../robot", "."], 0);
    assert_eq!(folder.read(&format!("cell/{START}")), usr);
    assert_eq!(folder.read("cell/.val3/controller.toml"), state);
}
