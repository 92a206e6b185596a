//! Lines of a log file.

use std::borrow::Cow;

use val3_syntax::encoding::decode;
use val3_syntax::foreign::ForeignContent;

use super::entry::{LineForm, LogEntry};
use super::{json_form, text_form};

/// Byte order mark of UTF-8.
const MARK: char = '\u{feff}';

/// Returns the entries of a log file. Every line that is not blank is an entry.
///
/// Each line is decoded by itself, as UTF-8, otherwise as ISO-8859-1: programs may log texts in another encoding than the
/// controller.
pub fn entries(bytes: &[u8]) -> impl Iterator<Item = LogEntry> {
    let lines = bytes.split(|byte| *byte == b'\n').enumerate();
    lines.filter_map(|(index, line)| line_entry(index + 1, line))
}

/// Returns the entry of the line with this number, from 1; `None` if it is blank.
#[must_use]
pub fn line_entry(number: usize, line: &[u8]) -> Option<LogEntry> {
    let text = decode(line.to_vec()).text;
    let text = text.trim_start_matches(MARK).trim_end_matches(['\r', '\n']);
    if text.trim().is_empty() {
        return None;
    }
    let parsed = json_form::entry(text).or_else(|| text_form::entry(text));
    Some(LogEntry { line: number, ..parsed.unwrap_or_else(|| unknown(text)) })
}

/// Returns the reason why a file is no log, for example because its text is UTF-16. An empty file is a log without
/// messages, and NUL bytes remain after a loss of power.
#[must_use]
pub fn foreign_content(bytes: &[u8]) -> Option<Cow<'static, str>> {
    match ForeignContent::of(bytes)? {
        ForeignContent::Empty | ForeignContent::NulBytes { .. } => None,
        foreign => Some(foreign.to_string().into()),
    }
}

fn unknown(text: &str) -> LogEntry {
    LogEntry {
        line: 0,
        form: LineForm::Unknown,
        time: None,
        uptime: None,
        level: None,
        code: None,
        text: text.to_owned(),
    }
}
