//! Logs of each version, and laws that hold for any log.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail loudly")]

use std::fmt::Write as _;

use expect_test::{Expect, expect};
use proptest::prelude::*;
use val3_backup::log::{
    LineForm, LoggedEntry, ProgramSources, RunningApplications, entries, explanation, foreign_content, line_entry,
    merged,
};
use val3_backup::{BackupFiles as _, MemoryFiles};

const S6: &str = include_str!("logs/s6-errors.log");
const S7: &str = include_str!("logs/s7-errors.log");
const S8: &str = include_str!("logs/s8-user.log");
const S8_SYSTEM: &str = include_str!("logs/s8-system.log");

fn shown(log: &[u8]) -> String {
    let mut text = String::new();
    for entry in entries(log) {
        let time = entry.time.map_or_else(|| "-".to_owned(), |time| time.to_string());
        let level = entry.known_level().map_or("-", |level| level.name());
        let code = entry.code.as_deref().unwrap_or("-");
        writeln!(text, "{} {:?} {time} {level} {code} {:?}", entry.line, entry.form, entry.text).unwrap();
    }
    text
}

fn check(log: &str, expected: Expect) {
    expected.assert_eq(&shown(log.as_bytes()));
}

#[test]
fn s6_has_no_codes() {
    check(
        S6,
        expect![[r#"
             1 Start 2012-03-14 09:30:00 - - "--------------------------------"
             2 Start 2012-03-14 09:30:00 - - "Logger started"
             3 Message 2012-03-14 09:30:07 INFO - "packer application started"
             4 Message 2012-03-14 09:31:40 ERROR - "(File pickPart.pgx-line 12) 'nCuont' : invalid name"
             6 Message 2012-03-14 09:32:00 ERROR - "ERR 10 Division by zero.. packer~."
        "#]],
    );
}

#[test]
fn s7_has_codes() {
    check(
        S7,
        expect![[r#"
            1 Start 2016-01-05 08:00:00 - - "--------------------------------"
            2 Start 2016-01-05 08:00:00 - - "Logger started"
            3 Message 2016-01-05 08:00:02 INFO 0x2401 "System: s7.8.3 {00c4ff10}"
            4 Message 2016-01-05 08:00:30 INFO 0x5402 "packer application started {1b2c3d4e}"
            5 Message 2016-01-05 08:01:11 INFO 0x5464 "USR:part 7 of 12"
            6 Message 2016-01-05 08:01:15 ERROR 0x5404 "ERR 123 IO not linked to a hardware input-output.. tGrip."
            7 Message 2016-01-05 08:01:16 - 0x3B07 "Cannot move: cannot cross singularity in this case."
            8 Message 2016-01-05 08:01:20 INFO 0x5403 "packer application stopped"
            9 Message 2016-01-05 08:01:21 - 0x9F01 "A message without a page"
            10 Unknown - - - "not a message at all"
        "#]],
    );
}

#[test]
fn s8_has_one_object_a_line() {
    check(
        S8,
        expect![[r#"
             1 Start 2021-01-05 08:00:00 - - "controller started (log version 3.0.0)"
             2 Message 2021-01-05 08:00:40 INFO 0x5402 "Application 'packer' started."
             3 Message 2021-01-05 08:00:50 ERROR 0x5404 "VAL3 runtime error. Cartesian position out of joint limits.. first.btnPark.click_clkPark. "
             4 Message 2021-01-05 08:00:50 ERROR 0x5404 "ERR 531 Cartesian position out of joint limits.. first.btnPark.click_clkPark. "
             5 Message 2021-01-05 08:01:30 ERROR 0x5405 "(File start.pgx-line 5) 'pik' : undefined program"
             6 Message 2021-01-05 08:02:00 INFO 0x5464 "bell \u{7} and\ttab"
             7 Message 2021-01-05 08:02:10 WARN 0x5401 "Application has ended, pending motion was cancelled."
        "#]],
    );
    check(
        S8_SYSTEM,
        expect![[r#"
             1 Unknown - - - "[01/05/21 07:59: DVM(INFO): Serial Number : F_00_0000000_C_001"
             2 Continuation 2021-01-05 07:59:58 - - "log continued from the older file (log version 3.0.0)"
             3 Message 2021-01-05 08:00:01 INFO 0x5B02 "CPU temperature: 50 degC"
             4 Message 2021-01-05 08:00:45 ERROR 0x1626 "Cannot settle arm power: user stop USIB (J100-5/6)."
             5 State 2021-01-05 08:01:30 - - "{\"controller\":{\"cpu\":1},\"timestamp\":91.5}"
             6 Message 2021-01-05 08:01:31 ERROR 0x7807 "Cannot load application 'Disk://packer/packer.pjx' - error in a program (see event logger)"
             7 Unknown - - - "{\"entry\":{\"date\":\"2021-01-05T08:03:00\",\"ts\":\"181.0\",\"type\":\"new\",\"val\":\"a type of a later version\"},\"hash\":\"e2b2c3d4e5f6a7b8c9\"}"
             8 Unknown - - - "{\"entry\":{\"date\":\"2021-01-05T08:03:01\",\"ts\":\"182.0\",\"type\":\"msg\",\"lvl\":\"INFO\",\"id\":\"0x7E01\",\"val\":\"No application run"
        "#]],
    );
}

#[test]
fn lines_are_decoded_one_by_one() {
    let mut log = "[01/05/21 08:00:00]: <0x5464> USR:Öffnen\n".as_bytes().to_vec();
    log.extend(b"[01/05/21 08:00:01]: <0x5464> USR:\xd6ffnen\n");
    expect![[r#"
         1 Message 2021-01-05 08:00:00 INFO 0x5464 "USR:Öffnen"
         2 Message 2021-01-05 08:00:01 INFO 0x5464 "USR:Öffnen"
    "#]]
    .assert_eq(&shown(&log));
}

#[test]
fn other_files_are_named() {
    assert_eq!(foreign_content(b""), None);
    assert_eq!(foreign_content(b"[01/05/21 08:00:00]: \0\0\0\0\0\0"), None);
    assert!(foreign_content(b"\xff\xfe[\0").unwrap().contains("UTF-16"));
    assert!(foreign_content(b"PK\x03\x04").unwrap().contains("ZIP"));
}

#[test]
fn messages_are_explained() {
    let mut text = String::new();
    for entry in [S6, S7, S8].iter().flat_map(|log| entries(log.as_bytes())) {
        if let Some(explanation) = explanation(&entry).filter(|explanation| !explanation.remedy.is_empty()) {
            writeln!(text, "{:?}: {}", explanation.topic, explanation.meaning).unwrap();
        }
    }
    expect![[r#"
        Name("invalid name"): name not declared
        RuntimeError(10): division by zero
        RuntimeError(123): input or output not linked
        Name("0x3B07"): move refused: singular position
        RuntimeError(531): point beyond the limits of the axes
        Name("undefined program"): program not in the project
        Name("0x5401"): application ended with pending moves
    "#]]
    .assert_eq(&text);
}

#[test]
fn the_running_application_is_known() {
    let mut running = RunningApplications::default();
    let mut text = String::new();
    for entry in entries(S7.as_bytes()) {
        running.advance(&entry);
        writeln!(text, "{} {}", entry.line, running.only().unwrap_or("-")).unwrap();
    }
    expect![[r#"
        1 -
        2 -
        3 -
        4 packer
        5 packer
        6 packer
        7 packer
        8 -
        9 -
        10 -
    "#]]
    .assert_eq(&text);
}

#[test]
fn logs_are_merged_by_time() {
    let log = |file: &str, text: &str| -> Vec<LoggedEntry> {
        entries(text.as_bytes()).map(|entry| LoggedEntry { file: file.to_owned(), entry }).collect()
    };
    let all = merged(vec![log("system.log", S8_SYSTEM), log("user.log", S8)]);
    let shown: Vec<String> = all.iter().map(|logged| format!("{}:{}", logged.file, logged.entry.line)).collect();
    expect!["system.log:1 system.log:2 user.log:1 system.log:3 user.log:2 system.log:4 user.log:3 user.log:4 system.log:5 user.log:5 system.log:6 system.log:7 system.log:8 user.log:6 user.log:7"].assert_eq(&shown.join(" "));
}

fn program(application: &str, line: &str) -> (String, Vec<u8>, Option<val3_backup::DateTime>) {
    let code = format!(
        "<Programs>\n<Program name=\"start\">\n<Code><![CDATA[\nbegin\n  {line}\nend\n]]></Code></Program></Programs>\n"
    );
    (format!("usr/usrapp/{application}/START.pgx"), code.into_bytes(), None)
}

fn source_lines(files: &MemoryFiles, message: &str, application: Option<&str>) -> String {
    let entry = line_entry(1, message.as_bytes()).unwrap();
    let found = ProgramSources::new(files.files()).lines(files, &entry.subject(), application);
    let shown = found.lines.iter().map(|line| {
        let changed = if line.is_changed { " (changed)" } else { "" };
        format!("{}: {}:{}: {}{changed}", line.application, line.path, line.line, line.text)
    });
    shown.collect::<Vec<_>>().join("\n")
}

#[test]
fn the_line_of_a_program_is_found() {
    let message = "[01/05/21 08:00:00]: (File start.pgx-line 2) 'pik' : undefined program";
    let files = MemoryFiles::new([program("one", "call pik()"), program("two", "call pick()")]);
    expect!["one: usr/usrapp/one/START.pgx:5: call pik()"].assert_eq(&source_lines(&files, message, None));
    let files = MemoryFiles::new([program("one", "call pik()"), program("two", "call pik()")]);
    expect![[r#"
        one: usr/usrapp/one/START.pgx:5: call pik()
        two: usr/usrapp/two/START.pgx:5: call pik()"#]]
    .assert_eq(&source_lines(&files, message, None));
    expect!["two: usr/usrapp/two/START.pgx:5: call pik()"].assert_eq(&source_lines(&files, message, Some("two")));
    let files = MemoryFiles::new([program("one", "call pick()")]);
    expect!["one: usr/usrapp/one/START.pgx:5: call pick() (changed)"].assert_eq(&source_lines(&files, message, None));
    assert_eq!(source_lines(&files, "[01/05/21 08:00:00]: (File start.pgx-line 200) 'a' : b", None), "");
    assert_eq!(source_lines(&files, "[01/05/21 08:00:00]: (File start.pgx-line 0) 'a' : b", None), "");
    assert_eq!(source_lines(&MemoryFiles::default(), message, None), "");
}

/// Texts of a log: random bytes, and parts of real forms.
fn log_text() -> impl Strategy<Value = Vec<u8>> {
    let part = prop_oneof![
        any::<Vec<u8>>(),
        "[ -~]{0,12}".prop_map(String::into_bytes),
        prop::sample::select(vec![S6, S7, S8, S8_SYSTEM]).prop_flat_map(|log| {
            let lines: Vec<&str> = log.lines().collect();
            prop::sample::select(lines).prop_map(|line| line.as_bytes().to_vec())
        }),
        Just(b"\n".to_vec()),
        Just(br#"{"entry":{"type":"key","val":"%s %% %5.2f %","data":[{"val":{"val":"%s"}},"#.to_vec()),
    ];
    prop::collection::vec(part, 0..12).prop_map(|parts| parts.concat())
}

proptest! {
    #[test]
    fn every_line_that_is_not_blank_is_an_entry(log in log_text()) {
        let found: Vec<usize> = entries(&log).map(|entry| entry.line).collect();
        let blank = |line: &[u8]| String::from_utf8_lossy(line).trim_start_matches('\u{feff}').trim().is_empty();
        let lines = log.split(|byte| *byte == b'\n').enumerate();
        let missing: Vec<usize> = lines.filter(|(index, line)| !blank(line) && !found.contains(&(index + 1))).map(|(index, _)| index + 1).collect();
        prop_assert!(missing.is_empty(), "{:?}", missing);
    }

    #[test]
    fn no_text_of_a_line_is_lost(text in "[ -~äöü]{1,30}") {
        let line = format!("[01/05/21 08:00:00]: <0x5464> x{text}x");
        let entry = line_entry(1, line.as_bytes()).unwrap();
        prop_assert_eq!(entry.text, format!("x{text}x"));
        let entry = line_entry(1, text.as_bytes());
        prop_assert!(text.trim().is_empty() || entry.is_some_and(|entry| entry.form != LineForm::Unknown || entry.text == text));
    }

    #[test]
    fn values_of_a_pattern_appear_in_the_text(values in prop::collection::vec("[a-z]{1,5}", 0..5), places in 0_usize..5) {
        let pattern = "%s ".repeat(places);
        let data: Vec<serde_json::Value> = values.iter().map(|value| serde_json::json!({"val": value})).collect();
        let line = serde_json::json!({"entry": {"type": "key", "val": pattern, "data": data}});
        let text = line_entry(1, line.to_string().as_bytes()).unwrap().text;
        prop_assert!(values.iter().all(|value| text.contains(value.as_str())), "{}", text);
    }

    #[test]
    fn merging_keeps_each_log_and_its_order(first in log_text(), second in log_text()) {
        let logged = |file: &str, log: &[u8]| -> Vec<LoggedEntry> {
            entries(log).map(|entry| LoggedEntry { file: file.to_owned(), entry }).collect()
        };
        let logs = [logged("a", &first), logged("b", &second)];
        let all = merged(logs.to_vec());
        for (name, log) in [("a", &logs[0]), ("b", &logs[1])] {
            let kept: Vec<&LoggedEntry> = all.iter().filter(|logged| logged.file == name).collect();
            prop_assert_eq!(kept.len(), log.len());
            prop_assert!(kept.iter().zip(log).all(|(kept, entry)| kept.entry.line == entry.entry.line));
        }
        for logged in &all {
            let _ = (explanation(&logged.entry), logged.entry.subject());
        }
    }
}
