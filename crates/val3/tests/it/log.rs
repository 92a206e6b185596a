//! `val3 log`.

use std::fs;

use expect_test::{Expect, expect};

use crate::archives::pack;
use crate::support::{CommandOutput, Folder, free_port};
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
    check(
        &folder.val3(&["log", "errors.log"]),
        expect![[r#"
        2016-01-05 08:00:00 --------------------------------
        2016-01-05 08:00:00 Logger started
        2016-01-05 08:00:02 INFO 0x2401 System: s7.8.3 {00c4ff10}
        2016-01-05 08:00:30 INFO 0x5402 packer application started {1b2c3d4e}
        2016-01-05 08:01:11 INFO 0x5464 USR:part 7 of 12
        2016-01-05 08:01:15 ERROR 0x5404 ERR 123 IO not linked to a hardware input-output.. tGrip.
            = application `packer`
            = run-time error 123, input or output not linked: The variable has no link to an input or output of this controller. Link it in the data editor, or with dioLink, aioLink or sioLink.
        2016-01-05 08:01:16 0x3B07 Cannot move: cannot cross singularity in this case.
            = move refused: singular position: The line or circle passes a singular position, which the configuration does not allow.
            = what to do: Replace the line by `movej`, or change the configuration of the target.
        2016-01-05 08:01:20 INFO 0x5403 packer application stopped
        2016-01-05 08:01:21 0x9F01 A message without a page
        not a message at all
        ---
        10 messages: 0 critical, 1 error, 0 warnings; 1 line in no known form, shown unchanged
    "#]],
    );
}

#[test]
fn the_logs_of_a_cell_are_merged_and_show_the_source_line() {
    check(
        &cell().val3(&["log"]),
        expect![[r#"
        [01/05/21 07:59: DVM(INFO): Serial Number : F_00_0000000_C_001
        2021-01-05 07:59:58 log continued from the older file (log version 3.0.0)
        2021-01-05 08:00:00 controller started (log version 3.0.0)
        2021-01-05 08:00:01 INFO 0x5B02 CPU temperature: 50 degC
        2021-01-05 08:00:40 INFO 0x5402 Application 'packer' started.
        2021-01-05 08:00:45 ERROR 0x1626 Cannot settle arm power: user stop USIB (J100-5/6).
            = arm power refused: The power of the arm cannot be switched on. The text gives the reason, such as an emergency stop.
            = what to do: Remove the reason, then switch the power on. A program sees the state with `isPowered()`.
        2021-01-05 08:00:50 ERROR 0x5404 VAL3 runtime error. Cartesian position out of joint limits.. first.btnPark.click_clkPark.
        2021-01-05 08:00:50 ERROR 0x5404 ERR 531 Cartesian position out of joint limits.. first.btnPark.click_clkPark.
            = application `packer`
            = run-time error 531, point beyond the limits of the axes: The arm would reach the point only with axes beyond their limits (s8). Correct the point, its frame or its tool; val3 check --motion reports such points.
        2021-01-05 08:01:30 {"controller":{"cpu":1},"timestamp":91.5}
        2021-01-05 08:01:30 ERROR 0x5405 (File start.pgx-line 5) 'pik' : undefined program
            usr/usrapp/packer/start.pgx:7: call pik()
            = program not in the project: `call` or `taskCreate` names a program that the project does not list.
            = what to do: Add the program to the project, or correct the spelling. `val3 check` proposes similar names (V0102).
        2021-01-05 08:01:31 ERROR 0x7807 Cannot load application 'Disk://packer/packer.pjx' - error in a program (see event logger)
            = application cannot be loaded: The application in the text could not be loaded, with the reason.
            = what to do: If a program has an error, read message 0x5405 of the same time in `user.log`. `val3 check` reports the fault.
        {"entry":{"date":"2021-01-05T08:03:00","ts":"181.0","type":"new","val":"a type of a later version"},"hash":"e2b2c3d4e5f6a7b8c9"}
        {"entry":{"date":"2021-01-05T08:03:01","ts":"182.0","type":"msg","lvl":"INFO","id":"0x7E01","val":"No application run
        2021-01-05 08:02:00 INFO 0x5464 bell ␇ and	tab
        2021-01-05 08:02:10 WARN 0x5401 Application has ended, pending motion was cancelled.
            = application `packer`
            = application ended with pending moves: The application ended before its moves, which were cancelled.
            = what to do: End the application with `waitEndMove()`.
        ---
        15 messages: 0 critical, 5 errors, 1 warning; 3 lines in no known form, shown unchanged
    "#]],
    );
}

#[test]
fn a_single_log_finds_the_cell_around_it() {
    let run = cell().val3(&["log", "log/user.log", "--level", "error"]);
    check(
        &run,
        expect![[r#"
        2021-01-05 08:00:00 controller started (log version 3.0.0)
        2021-01-05 08:00:50 ERROR 0x5404 VAL3 runtime error. Cartesian position out of joint limits.. first.btnPark.click_clkPark.
        2021-01-05 08:00:50 ERROR 0x5404 ERR 531 Cartesian position out of joint limits.. first.btnPark.click_clkPark.
            = application `packer`
            = run-time error 531, point beyond the limits of the axes: The arm would reach the point only with axes beyond their limits (s8). Correct the point, its frame or its tool; val3 check --motion reports such points.
        2021-01-05 08:01:30 ERROR 0x5405 (File start.pgx-line 5) 'pik' : undefined program
            usr/usrapp/packer/start.pgx:7: call pik()
            = program not in the project: `call` or `taskCreate` names a program that the project does not list.
            = what to do: Add the program to the project, or correct the spelling. `val3 check` proposes similar names (V0102).
        ---
        4 messages: 0 critical, 3 errors, 0 warnings; 3 more not selected
    "#]],
    );
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
    expect![[r#"
        {
          "application": "packer",
          "cause": "`call` or `taskCreate` names a program that the project does not list.",
          "code": "0x5405",
          "code_line": 5,
          "error": null,
          "file": "log/user.log",
          "form": "message",
          "level": "ERROR",
          "line": 5,
          "meaning": "program not in the project",
          "program": "start",
          "remedy": "Add the program to the project, or correct the spelling. `val3 check` proposes similar names (V0102).",
          "sources": [
            {
              "application": "packer",
              "changed": false,
              "file": "usr/usrapp/packer/start.pgx",
              "line": 7,
              "text": "call pik()"
            }
          ],
          "task": null,
          "text": "(File start.pgx-line 5) 'pik' : undefined program",
          "time": "2021-01-05 08:01:30",
          "topic": "undefined program",
          "uptime": 91.5
        }"#]].assert_eq(&serde_json::to_string_pretty(rejected).unwrap());
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
    check(
        &folder.val3(&["log", "errors.log"]),
        expect![[r#"
        2021-01-05 08:00:00 INFO 0x5464 USR:Öffnen
        2021-01-05 08:00:01 INFO 0x5464 USR:Öffnen ␛[2J
        ---
        2 messages: 0 critical, 0 errors, 0 warnings
    "#]],
    );
}

#[test]
fn files_that_are_no_log_are_refused() {
    let folder = Folder::empty();
    fs::write(folder.path().join("errors.log"), b"\xff\xfe[\0").unwrap();
    folder.write("a/log/user.log", "");
    folder.write("b/log/user.log", "");
    folder.write("c/readme.txt", "");
    let messages =
        [("errors.log", "UTF-16"), ("none.log", "does not exist"), ("c", "there is no log in `c`"), ("a", "")];
    for (path, message) in messages {
        let run = folder.val3(&["log", path]);
        assert_eq!(run.code, if message.is_empty() { 0 } else { 2 }, "{path}: {run:?}");
        assert!(run.stderr.to_lowercase().contains(&message.to_lowercase()), "{path}: {run:?}");
    }
    fs::remove_file(folder.path().join("errors.log")).unwrap();
    let run = folder.val3(&["log"]);
    assert!(run.code == 2 && run.stderr.contains("`a/log`, `b/log`"), "{run:?}");
}

/// `tests/python/test_controller.py` reads logs from a server.
#[test]
fn addresses_that_cannot_be_read_have_a_remedy() {
    let folder = Folder::empty();
    let closed = format!("ftp://127.0.0.1:{}", free_port());
    let error = |args: &[&str]| {
        let run = folder.val3(args);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{}", run.stderr);
        run.stderr
    };
    for command in ["log", "info"] {
        assert!(error(&[command, &closed]).contains("check the cable"));
        let message = error(&[command, "ftp://me:hidden@robot"]);
        assert!(message.contains("a password does not belong") && !message.contains("hidden"), "{message}");
        assert!(error(&[command, "http://robot"]).contains("write `ftp://PROFILE@HOST`"));
    }
    expect![[r#"
        error: --follow requires a file, because a controller transfers only entire logs
          help: repeat the command without --follow, with --since 10m
    "#]]
    .assert_eq(&error(&["log", "--follow", &closed]));
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

/// A link out of the folder is not followed, so that there may be further logs behind it.
#[cfg(unix)]
#[test]
fn folders_that_are_not_searched_are_named() {
    let folder = cell();
    let outside = Folder::empty();
    std::os::unix::fs::symlink(outside.path(), folder.path().join("log/older")).unwrap();
    let run = folder.val3(&["log", "."]);
    assert!(run.code == 2 && run.stdout.contains("0x5405"), "{run:?}");
    assert!(run.stderr.contains("error: no logs are searched in `log/older`: "), "{run:?}");
    fs::remove_dir_all(folder.path().join("usr")).unwrap();
    fs::remove_file(folder.path().join("log/user.log")).unwrap();
    fs::remove_file(folder.path().join("log/system.log")).unwrap();
    let run = folder.val3(&["log", "."]);
    assert!(run.code == 2 && run.stderr.contains("no logs are searched in `log/older`: "), "{run:?}");
}
