//! Logs of each version, and laws of reading them.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail loudly")]

use std::fmt::Write as _;

use expect_test::{Expect, expect};
use proptest::prelude::*;
use val3_backup::log::{
    LineForm, LoggedEntry, ProgramSources, RunningApplications, entries, explanation, foreign_content, line_entry, merged,
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
        writeln!(text, "{:>2} {:?} {time} {level} {code} {:?}", entry.line, entry.form, entry.text).unwrap();
    }
    text
}

fn check(log: &str, expected: Expect) {
    expected.assert_eq(&shown(log.as_bytes()));
}

#[test]
fn s6_has_no_codes() {
    check(S6, expect![[r#""#]]);
}

#[test]
fn s7_has_codes() {
    check(S7, expect![[r#""#]]);
}

#[test]
fn s8_has_one_object_a_line() {
    check(S8, expect![[r#""#]]);
    check(S8_SYSTEM, expect![[r#""#]]);
}

#[test]
fn lines_are_decoded_one_by_one() {
    let mut log = "[01/05/21 08:00:00]: <0x5464> USR:Öffnen\n".as_bytes().to_vec();
    log.extend(b"[01/05/21 08:00:01]: <0x5464> USR:\xd6ffnen\n");
    expect![[r#""#]].assert_eq(&shown(&log));
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
    expect![[r#""#]].assert_eq(&text);
}

#[test]
fn the_running_application_is_known() {
    let mut running = RunningApplications::default();
    let mut text = String::new();
    for entry in entries(S7.as_bytes()) {
        running.advance(&entry);
        writeln!(text, "{} {}", entry.line, running.only().unwrap_or("-")).unwrap();
    }
    expect![[r#""#]].assert_eq(&text);
}

#[test]
fn logs_are_merged_by_time() {
    let log = |file: &str, text: &str| -> Vec<LoggedEntry> {
        entries(text.as_bytes()).map(|entry| LoggedEntry { file: file.to_owned(), entry }).collect()
    };
    let all = merged(vec![log("system.log", S8_SYSTEM), log("user.log", S8)]);
    let shown: Vec<String> = all.iter().map(|logged| format!("{}:{}", logged.file, logged.entry.line)).collect();
    expect![[r#""#]].assert_eq(&shown.join(" "));
}

fn program(application: &str, line: &str) -> (String, Vec<u8>, Option<val3_backup::DateTime>) {
    let code = format!("<Programs>\n<Program name=\"start\">\n<Code><![CDATA[\nbegin\n  {line}\nend\n]]></Code></Program></Programs>\n");
    (format!("usr/usrapp/{application}/START.pgx"), code.into_bytes(), None)
}

fn source_lines(files: &MemoryFiles, message: &str, application: Option<&str>) -> String {
    let entry = line_entry(1, message.as_bytes()).unwrap();
    let found = ProgramSources::new(files.files()).lines(files, &entry.subject(), application);
    let shown = found.iter().map(|line| {
        let changed = if line.is_changed { " (changed)" } else { "" };
        format!("{}: {}:{}: {}{changed}", line.application, line.path, line.line, line.text)
    });
    shown.collect::<Vec<_>>().join("\n")
}

#[test]
fn the_line_of_a_program_is_found() {
    let message = "[01/05/21 08:00:00]: (File start.pgx-line 2) 'pik' : undefined program";
    let files = MemoryFiles::new([program("one", "call pik()"), program("two", "call pick()")]);
    expect![[r#""#]].assert_eq(&source_lines(&files, message, None));
    let files = MemoryFiles::new([program("one", "call pik()"), program("two", "call pik()")]);
    expect![[r#""#]].assert_eq(&source_lines(&files, message, None));
    expect![[r#""#]].assert_eq(&source_lines(&files, message, Some("two")));
    let files = MemoryFiles::new([program("one", "call pick()")]);
    expect![[r#""#]].assert_eq(&source_lines(&files, message, None));
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
        let _ = all.iter().map(|logged| (explanation(&logged.entry), logged.entry.subject())).count();
    }
}
