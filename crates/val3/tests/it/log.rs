//! `val3 log`.

use std::fs;

use expect_test::{Expect, expect};

use crate::archives::pack;
use crate::support::{CommandOutput, Folder};
use crate::waiting::OutputLines;

const S7: &str = include_str!("../../../val3-backup/tests/logs/s7-errors.log");
const S8: &str = include_str!("../../../val3-backup/tests/logs/s8-user.log");
const S8_SYSTEM: &str = include_str!("../../../val3-backup/tests/logs/s8-system.log");

/// Cell with the application of the s8 logs. The call in line 5 of its code is in line 7 of the file.
fn cell() -> Folder {
    let folder = Folder::empty();
    let code = "begin\n  cls()\n  cls()\n  cls()\n  call pik()\nend\n";
    let program =
        format!("<Programs>\n<Program name=\"start\">\n<Code><![CDATA[{code}]]></Code>\n</Program>\n</Programs>\n");
    folder.write("usr/usrapp/packer/start.pgx", &program);
    folder.write("usr/usrapp/packer/packer.pjx", "<Project/>\n");
    folder.write("log/user.log", S8);
    folder.write("log/system.log", S8_SYSTEM);
    folder
}

#[track_caller]
fn check(run: &CommandOutput, expected: Expect) {
    assert_eq!(run.code, 0, "{run:?}");
    expected.assert_eq(&format!("{}---\n{}", run.stdout, run.stderr));
}

#[test]
fn a_cs8_log_is_shown_with_its_remedies() {
    let folder = Folder::empty();
    folder.write("errors.log", S7);
    check(&folder.val3(&["log", "errors.log"]), expect![[r#""#]]);
}

#[test]
fn the_logs_of_a_cell_are_merged_and_show_the_source_line() {
    check(&cell().val3(&["log"]), expect![[r#""#]]);
}

#[test]
fn a_single_log_finds_the_cell_around_it() {
    let run = cell().val3(&["log", "log/user.log", "--level", "error"]);
    check(&run, expect![[r#""#]]);
}

#[test]
fn messages_are_selected_by_time() {
    let folder = cell();
    for since in ["2021-01-05T08:02", "1m"] {
        let run = folder.val3(&["log", "log/user.log", "--since", since]);
        let texts: Vec<&str> = run.stdout.lines().filter(|line| line.starts_with("2021")).collect();
        assert_eq!(texts.len(), 3 - usize::from(since != "1m"), "{run:?}");
        assert!(run.stderr.contains("more not selected"), "{run:?}");
    }
    let run = folder.val3(&["log", "--since", "yesterday"]);
    assert!(run.code == 2 && run.stderr.contains("2021-01-05T08:00"), "{run:?}");
}

#[test]
fn sources_can_be_elsewhere_and_in_an_archive() {
    let folder = Folder::empty();
    folder.write("user.log", S8);
    let archive = folder.path().join("backup.zip");
    pack(&cell(), &archive);
    for arguments in [["log", "user.log", "--sources", "backup.zip"].as_slice(), &["log", "backup.zip"]] {
        let run = folder.val3(arguments);
        assert!(run.code == 0 && run.stdout.contains("packer/start.pgx:7: call pik()"), "{run:?}");
    }
}

#[test]
fn the_document_contains_every_line() {
    let folder = cell();
    let run = folder.val3(&["log", "--format", "json"]);
    let document: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    let messages = document["messages"].as_array().unwrap();
    let lines = S8.lines().chain(S8_SYSTEM.lines()).count();
    assert_eq!((document["version"].as_u64(), messages.len()), (Some(1), lines));
    assert_eq!(document["counts"]["lines"].as_u64(), u64::try_from(lines).ok());
    let rejected = messages.iter().find(|message| message["code"] == "0x5405").unwrap();
    expect![[r#""#]].assert_eq(&serde_json::to_string_pretty(rejected).unwrap());
    let run = folder.val3(&["log", "--format", "json-lines", "--output", "messages.json"]);
    assert_eq!(run.code, 0, "{run:?}");
    assert_eq!(folder.read("messages.json").lines().count(), lines);
}

#[test]
fn latin_1_and_utf_8_are_read() {
    let folder = Folder::empty();
    let mut log = "\u{feff}[01/05/21 08:00:00]: <0x5464> USR:Öffnen\r\n".as_bytes().to_vec();
    log.extend(b"[01/05/21 08:00:01]: <0x5464> USR:\xd6ffnen \x1b[2J\r\n");
    fs::write(folder.path().join("errors.log"), log).unwrap();
    check(&folder.val3(&["log", "errors.log"]), expect![[r#""#]]);
}

#[test]
fn files_that_are_no_log_are_refused() {
    let folder = Folder::empty();
    fs::write(folder.path().join("errors.log"), b"\xff\xfe[\0").unwrap();
    folder.write("a/log/user.log", "");
    folder.write("b/log/user.log", "");
    folder.write("c/readme.txt", "");
    let messages = [("errors.log", "UTF-16"), ("none.log", "does not exist"), ("c", "there is no log in `c`"), ("a", "")];
    for (path, message) in messages {
        let run = folder.val3(&["log", path]);
        assert_eq!(run.code, if message.is_empty() { 0 } else { 2 }, "{path}: {run:?}");
        assert!(run.stderr.to_lowercase().contains(&message.to_lowercase()), "{path}: {run:?}");
    }
    fs::remove_file(folder.path().join("errors.log")).unwrap();
    let run = folder.val3(&["log"]);
    assert!(run.code == 2 && run.stderr.contains("`a/log`, `b/log`"), "{run:?}");
}

#[test]
fn further_messages_are_followed() {
    let folder = cell();
    let mut command = folder.command(&["log", "log/user.log", "--follow", "--format", "json-lines"]);
    let mut child = command.stdout(std::process::Stdio::piped()).spawn().unwrap();
    let lines = OutputLines::of(child.stdout.take().unwrap());
    lines.wait_for("pending motion");
    folder.write("log/user.log", &format!("{S8}{}", S7.lines().nth(4).unwrap()));
    std::thread::sleep(std::time::Duration::from_millis(500));
    folder.write("log/user.log", &format!("{S8}{}\n", S7.lines().nth(4).unwrap()));
    lines.wait_for("USR:part 7 of 12");
    child.kill().unwrap();
    child.wait().unwrap();
    for arguments in [["log", "log", "--follow"].as_slice(), &["log", "log/user.log", "--follow", "--format", "json"]] {
        let run = folder.val3(arguments);
        assert!(run.code == 2 && run.stderr.contains("--follow"), "{run:?}");
    }
}
