//! Lines of `errors.log` (CS8).
//!
//! `[01/05/21 08:00:00]: <0x5402> demo application started {1a2b3c4d}`. The code is missing in s6, and the number in
//! braces is missing in s6 and in early versions of s7. A start is a line of hyphens and the line `Logger started`.

use super::entry::{LineForm, LogEntry};
use crate::DateTime;

/// Returns the entry of a line; `None` if the line has another form.
pub(super) fn entry(line: &str) -> Option<LogEntry> {
    let (time, rest) = line.strip_prefix('[')?.split_once("]:")?;
    let time = DateTime::parse_cs8(time)?;
    let rest = rest.trim();
    let (code, text) = match rest.strip_prefix('<').and_then(|rest| rest.split_once('>')) {
        Some((code, text)) if is_code(code) => (Some(code.to_owned()), text.trim_start()),
        _ => (None, rest),
    };
    let is_start = code.is_none() && (text == "Logger started" || is_rule(text));
    let form = if is_start { LineForm::Start } else { LineForm::Message };
    Some(LogEntry { line: 0, form, time: Some(time), uptime: None, level: None, code, text: text.to_owned() })
}

fn is_code(text: &str) -> bool {
    text.strip_prefix("0x")
        .is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_hexdigit()))
}

fn is_rule(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte == b'-')
}
