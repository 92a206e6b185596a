//! Lines of `system.log` and `user.log` (CS9): `{"entry": {…}, "hash": "…"}`.
//!
//! The `type` of the entry is `msg` (`val` is the text), `key` (`val` is a pattern with `%s` and similar places, which
//! `data` fills), `state` (`val` is an object with inputs and outputs), `run` (start) or `swap` (start of a file after
//! the old one was renamed).

use serde_json::Value;
use val3_lang::log_messages::LogLevel;

use super::entry::{LineForm, LogEntry};
use crate::DateTime;

/// Maximum depth of patterns in patterns.
const DEPTH: usize = 8;

/// Returns the entry of a line; `None` if the line has another form.
pub(super) fn entry(line: &str) -> Option<LogEntry> {
    let document: Value = serde_json::from_str(line).or_else(|_| serde_json::from_str(&escaped(line))).ok()?;
    let entry = document.get("entry")?;
    let text = |key: &str| entry.get(key).and_then(Value::as_str);
    let (form, message) = match text("type")? {
        "msg" => (LineForm::Message, shown(entry.get("val")?)),
        "key" => (LineForm::Message, filled(entry, 0)?),
        "state" => (LineForm::State, shown(entry.get("val")?)),
        "run" => (LineForm::Start, start("controller started", text("version"))),
        "swap" => (LineForm::Continuation, start("log continued from the older file", text("version"))),
        _ => return None,
    };
    Some(LogEntry {
        line: 0,
        form,
        time: text("date").and_then(DateTime::parse),
        uptime: text("ts").and_then(|seconds| seconds.parse().ok()).filter(|seconds: &f64| seconds.is_finite()),
        level: text("lvl").and_then(LogLevel::from_name),
        code: text("id").map(str::to_owned),
        text: message,
    })
}

fn start(what: &str, version: Option<&str>) -> String {
    version.map_or_else(|| what.to_owned(), |version| format!("{what} (log version {version})"))
}

/// Inserts the values of `data` in the pattern of `val`. Values without a place in the pattern are appended.
/// `None` if there is no pattern.
fn filled(entry: &Value, depth: usize) -> Option<String> {
    let pattern = shown(entry.get("val")?);
    let data = entry.get("data").and_then(Value::as_array).map(Vec::as_slice).unwrap_or_default();
    let mut values = data.iter().map(|value| value_text(value, depth));
    let mut text = String::with_capacity(pattern.len());
    let mut rest = pattern.as_str();
    while let Some((before, place, after)) = next_place(rest) {
        text.push_str(before);
        match values.next() {
            Some(value) => text.push_str(&value),
            None => text.push_str(place),
        }
        rest = after;
    }
    text.push_str(rest);
    for value in values {
        text.push(' ');
        text.push_str(&value);
    }
    Some(text)
}

/// Text of a value, which can be a pattern with values itself.
fn value_text(value: &Value, depth: usize) -> String {
    let is_pattern = value.get("data").is_some() && depth < DEPTH;
    let filled = is_pattern.then(|| filled(value, depth + 1)).flatten();
    filled.unwrap_or_else(|| shown(value.get("val").unwrap_or(value)))
}

/// Splits a text at its first place for a value, such as `%s`, `%5.2f` or `%lu`.
fn next_place(text: &str) -> Option<(&str, &str, &str)> {
    text.match_indices('%').find_map(|(start, _)| {
        let place = text.get(start..)?;
        let is_middle = |letter: char| letter.is_ascii_digit() || "+-. #lh".contains(letter);
        let end = 1 + place.get(1..)?.find(|letter| !is_middle(letter))?;
        let letter = place.get(end..)?.chars().next().filter(|letter| "sdiugfexXc".contains(*letter))?;
        let end = end + letter.len_utf8();
        Some((text.get(..start)?, place.get(..end)?, place.get(end..)?))
    })
}

/// Text of a JSON value. The fraction of a whole number, which the controller writes as `50.000000000`, is omitted.
fn shown(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => {
            number.as_f64().filter(|_| number.is_f64()).map_or_else(|| number.to_string(), |number| number.to_string())
        }
        other => other.to_string(),
    }
}

/// Escapes control characters, which the controller writes unescaped in texts of programs.
fn escaped(line: &str) -> String {
    let escape = |letter: char| if letter < ' ' { format!("\\u{:04x}", u32::from(letter)) } else { letter.to_string() };
    line.chars().map(escape).collect()
}
