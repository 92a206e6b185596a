//! A finding and the places it points at.

use std::ops::Range;
use std::sync::Arc;

use val3_check::fingerprint::Fingerprint;
use val3_lines::{Columns, LineColumn, LineIndex};
use val3_syntax::encoding::Encoding;

use super::Severity;

/// A position in a file, counted as in editors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Position {
    /// Line, from 1.
    pub(crate) line: usize,
    /// Column in characters, from 1.
    pub(crate) column: usize,
    /// Bytes of the stored file before this position.
    pub(crate) offset: usize,
}

/// A file that findings point at.
#[derive(Debug)]
pub(crate) struct SourceFile {
    /// The path relative to the requested folder, with `/`.
    pub(crate) path: String,
    /// The path as people open it: relative to the current folder where that is shorter.
    pub(crate) shown: String,
    /// The path relative to the folder of the version control, with `/`.
    pub(crate) in_repository: String,
    /// The path on the controller (`Disk://app/prog.pgx`), where it has one.
    pub(crate) disk: Option<String>,
    /// The text, decoded.
    pub(crate) text: Arc<str>,
    /// The lines of the text.
    pub(crate) lines: LineIndex,
    /// The encoding of the stored file.
    encoding: Encoding,
}

impl SourceFile {
    /// A file under one path, without a place on a controller.
    pub(crate) fn new(path: &str, text: Arc<str>, encoding: Encoding) -> Self {
        Self {
            path: path.to_owned(),
            shown: path.to_owned(),
            in_repository: path.to_owned(),
            disk: None,
            lines: LineIndex::new(&text),
            text,
            encoding,
        }
    }

    /// The position of a character boundary. An offset after the end means the end.
    pub(crate) fn position(&self, offset: usize) -> Position {
        let offset = offset.min(self.text.len());
        let LineColumn { line, column } = self.lines.line_column(offset, Columns::SHOWN_CHARACTERS);
        Position { line: line as usize + 1, column: column as usize + 1, offset: self.stored_offset(offset) }
    }

    fn stored_offset(&self, offset: usize) -> usize {
        match self.encoding {
            Encoding::Utf8 => offset,
            Encoding::Latin1 => self.lines.characters(offset),
        }
    }
}

/// A range of a file.
#[derive(Debug, Clone)]
pub(crate) struct ReportRange {
    /// The file.
    pub(crate) file: Arc<SourceFile>,
    /// Bytes of the decoded text.
    pub(crate) range: Range<usize>,
}

impl ReportRange {
    /// Where it starts.
    pub(crate) fn start(&self) -> Position {
        self.file.position(self.range.start)
    }

    /// Where it ends: the first place that is not part of it.
    pub(crate) fn end(&self) -> Position {
        self.file.position(self.range.end)
    }
}

/// One finding.
#[derive(Debug, Clone)]
pub(crate) struct Finding {
    /// `V0203`
    pub(crate) code: &'static str,
    /// `argument-type`
    pub(crate) name: &'static str,
    /// Its level.
    pub(crate) severity: Severity,
    /// The message: one sentence.
    pub(crate) message: String,
    /// A few words under the place; may be empty.
    pub(crate) label: String,
    /// The remedy; may be empty.
    pub(crate) help: String,
    /// Its identity in baselines, with the path relative to the folder of the version control.
    pub(crate) fingerprint: Fingerprint,
    /// The place.
    pub(crate) place: ReportRange,
    /// The program that contains the place.
    pub(crate) program: Option<String>,
    /// The line within the program's code, where the line of `begin` is 1.
    pub(crate) code_line: Option<usize>,
    /// The path of the application's `.pjx`, like [`SourceFile::path`].
    pub(crate) application: Option<String>,
    /// Whether the last check did not have it.
    pub(crate) is_new: bool,
    /// The other sides of the fault.
    pub(crate) related: Vec<Related>,
    /// The fix.
    pub(crate) fix: Option<Fix>,
}

impl Finding {
    /// The message, with a mark if the finding is new since the last check.
    pub(crate) fn marked_message(&self) -> String {
        if self.is_new { format!("{} (new)", self.message) } else { self.message.clone() }
    }

    /// The message with the remedy, for outputs that show one text.
    pub(crate) fn message_with_help(&self) -> String {
        if self.help.is_empty() { self.message.clone() } else { format!("{}; {}", self.message, self.help) }
    }
}

/// A change that fixes a finding.
#[derive(Debug, Clone)]
pub(crate) struct Fix {
    /// The description of the change, as an order.
    pub(crate) title: String,
    /// Whether it is applied without asking.
    pub(crate) safe: bool,
    /// The replacements.
    pub(crate) edits: Vec<Edit>,
}

/// Replaces a place.
#[derive(Debug, Clone)]
pub(crate) struct Edit {
    /// The place.
    pub(crate) place: ReportRange,
    /// The new text of the place.
    pub(crate) text: String,
}

/// Another side of a finding.
#[derive(Debug, Clone)]
pub(crate) struct Related {
    /// The place.
    pub(crate) place: ReportRange,
    /// The message for the place.
    pub(crate) message: String,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn position(file: &SourceFile, offset: usize) -> (usize, usize, usize) {
        let position = file.position(offset);
        (position.line, position.column, position.offset)
    }

    #[test]
    fn lines_and_columns_count_from_1() {
        let file = SourceFile::new("a.pgx", "aé\r\nb".into(), Encoding::Utf8);
        assert_eq!(position(&file, 3), (1, 3, 3));
        assert_eq!(position(&file, 5), (2, 1, 5));
        assert_eq!(position(&file, 99), (2, 2, 6));
    }

    #[test]
    fn offsets_of_latin1_count_characters() {
        let file = SourceFile::new("a.pgx", "é\nü=1".into(), Encoding::Latin1);
        assert_eq!(position(&file, 3), (2, 1, 2));
        assert_eq!(position(&file, 5), (2, 2, 3));
        assert_eq!(position(&file, 99), (2, 4, 5));
    }

    #[test]
    fn a_byte_order_mark_takes_bytes_and_no_column() {
        let file = SourceFile::new("a.pgx", "\u{feff}<a>".into(), Encoding::Utf8);
        assert_eq!(position(&file, 3), (1, 1, 3));
        assert_eq!(position(&file, 4), (1, 2, 4));
    }
}
