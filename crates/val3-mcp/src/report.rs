//! Access to the reports of commands: JSON and messages.

use serde_json::Value;

/// Messages of a command, one per line, without hints about options that a call does not have.
pub(crate) fn notes(messages: &str) -> String {
    let is_advice = |line: &str| line.trim_start().starts_with("help:") && line.contains("--");
    messages.trim().lines().filter(|line| !is_advice(line)).map(|line| format!("\n{line}")).collect()
}

/// String under `key` in a JSON object; empty if it is missing or no string.
pub(crate) fn text<'v>(value: &'v Value, key: &str) -> &'v str {
    value.get(key).and_then(Value::as_str).unwrap_or_default()
}

/// Number under `key` in a JSON object; 0 if it is missing or no number.
pub(crate) fn number(value: &Value, key: &str) -> u64 {
    value.get(key).and_then(Value::as_u64).unwrap_or_default()
}

/// Items of the array under `key` in a JSON object; empty if it is missing or no array.
pub(crate) fn items<'v>(value: &'v Value, key: &str) -> &'v [Value] {
    value.get(key).and_then(Value::as_array).map(Vec::as_slice).unwrap_or_default()
}

/// A count with its noun, for example `1 error` or `2 errors`.
pub(crate) fn counted(count: u64, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}
