//! A finding and the places it points at.

use std::ops::Range;
use std::sync::Arc;

use val3_check::fingerprint::Fingerprint;
use val3_syntax::encoding::Encoding;

use super::Severity;
use crate::line_index::{LineIndex, Position};

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
}

impl SourceFile {
    /// A file under one path, without a place on a controller.
    pub(crate) fn new(path: &str, text: Arc<str>, encoding: Encoding) -> Self {
        Self {
            path: path.to_owned(),
            shown: path.to_owned(),
            in_repository: path.to_owned(),
            disk: None,
            lines: LineIndex::new(&text, encoding),
            text,
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
        self.file.lines.position(self.range.start)
    }

    /// Where it ends: the first place that is not part of it.
    pub(crate) fn end(&self) -> Position {
        self.file.lines.position(self.range.end)
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
