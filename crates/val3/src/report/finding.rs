//! A finding and its locations.

use std::ops::Range;
use std::sync::Arc;

use val3_check::fingerprint::Fingerprint;
use val3_lines::{ColumnCounting, LineColumn, LineIndex};
use val3_syntax::encoding::Encoding;

use super::FindingSeverity;

/// A position in a file, counted as in editors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct ReportPosition {
    /// Line, from 1.
    pub(crate) line: usize,
    /// Column in characters, from 1.
    pub(crate) column: usize,
    /// Offset in bytes of the stored file.
    pub(crate) offset: usize,
}

/// A file to which findings refer.
#[derive(Debug)]
pub(crate) struct SourceFile {
    /// Path relative to the requested folder, with `/`.
    pub(crate) path: String,
    /// Path as displayed: relative to the current folder if that is shorter.
    pub(crate) shown: String,
    /// Path relative to the repository's root, with `/`.
    pub(crate) in_repository: String,
    /// Path on the controller (`Disk://app/prog.pgx`), if it has one.
    pub(crate) disk: Option<String>,
    /// Decoded text.
    pub(crate) text: Arc<str>,
    /// Line index of the text.
    pub(crate) lines: LineIndex,
    /// Encoding of the stored file.
    encoding: Encoding,
}

impl SourceFile {
    /// Creates a file whose paths are all `path`, without a path on a controller.
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

    /// Position of an offset, which must be a character boundary. An offset after the end is clamped to the end.
    pub(crate) fn position(&self, offset: usize) -> ReportPosition {
        let offset = offset.min(self.text.len());
        let LineColumn { line, column } = self.lines.line_column(offset, ColumnCounting::SHOWN_CHARACTERS);
        ReportPosition { line: line as usize + 1, column: column as usize + 1, offset: self.stored_offset(offset) }
    }

    fn stored_offset(&self, offset: usize) -> usize {
        match self.encoding {
            Encoding::Utf8 => offset,
            Encoding::Latin1 | Encoding::Windows1252 => self.lines.characters(offset),
        }
    }
}

/// A range of a file.
#[derive(Debug, Clone)]
pub(crate) struct ReportRange {
    /// File.
    pub(crate) file: Arc<SourceFile>,
    /// Byte range of the decoded text.
    pub(crate) range: Range<usize>,
}

impl ReportRange {
    /// Start position.
    pub(crate) fn start(&self) -> ReportPosition {
        self.file.position(self.range.start)
    }

    /// End position: the first position after the range.
    pub(crate) fn end(&self) -> ReportPosition {
        self.file.position(self.range.end)
    }
}

/// One finding.
#[derive(Debug, Clone)]
pub(crate) struct Finding {
    /// Code, for example `V0203`.
    pub(crate) code: &'static str,
    /// Name, for example `argument-type`.
    pub(crate) name: &'static str,
    /// Level.
    pub(crate) severity: FindingSeverity,
    /// Message: one sentence.
    pub(crate) message: String,
    /// Label of the marked range, a few words; may be empty.
    pub(crate) label: String,
    /// Remedy; may be empty.
    pub(crate) help: String,
    /// Identity in baselines, with the path relative to the repository's root.
    pub(crate) fingerprint: Fingerprint,
    /// Location.
    pub(crate) place: ReportRange,
    /// Program that contains the location.
    pub(crate) program: Option<String>,
    /// Line number within the program's code, where the line of `begin` is 1.
    pub(crate) code_line: Option<usize>,
    /// Path of the application's `.pjx`, as in [`SourceFile::path`].
    pub(crate) application: Option<String>,
    /// Whether the previous check did not have the finding.
    pub(crate) is_new: bool,
    /// Related locations.
    pub(crate) related: Vec<Related>,
    /// Fix.
    pub(crate) fix: Option<ReportedFix>,
}

impl Finding {
    /// Message, marked if the finding is new.
    pub(crate) fn marked_message(&self) -> String {
        if self.is_new { format!("{} (new)", self.message) } else { self.message.clone() }
    }

    /// Message with the remedy, for outputs with only one text.
    pub(crate) fn message_with_help(&self) -> String {
        if self.help.is_empty() { self.message.clone() } else { format!("{}; {}", self.message, self.help) }
    }
}

/// A change that fixes a finding.
#[derive(Debug, Clone)]
pub(crate) struct ReportedFix {
    /// Description of the change, as a request.
    pub(crate) title: String,
    /// Whether the fix is applied without a request by the user.
    pub(crate) safe: bool,
    /// Replacements.
    pub(crate) edits: Vec<ReportedEdit>,
}

/// A replacement.
#[derive(Debug, Clone)]
pub(crate) struct ReportedEdit {
    /// Replaced range.
    pub(crate) place: ReportRange,
    /// New text of the range.
    pub(crate) text: String,
}

/// A related location of a finding.
#[derive(Debug, Clone)]
pub(crate) struct Related {
    /// Location.
    pub(crate) place: ReportRange,
    /// Message for the location.
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
