//! Text lines that differ.

use serde::Serialize;

use super::change::Change;

/// Lines that differ, with context.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Hunk {
    /// First old line, from 1; the preceding line if the hunk has no old lines.
    pub old_start: usize,
    /// Number of old lines.
    pub old_lines: usize,
    /// First new line, from 1; the preceding line if the hunk has no new lines.
    pub new_start: usize,
    /// Number of new lines.
    pub new_lines: usize,
    /// The lines.
    pub lines: Vec<HunkLine>,
}

/// A line of a hunk.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct HunkLine {
    /// Versions that contain the line.
    pub kind: LineKind,
    /// Line number, from 1, in the version with the line; in the new version if both contain it.
    pub number: usize,
    /// Text without its line end.
    pub text: String,
}

/// Versions that contain a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum LineKind {
    /// Both versions.
    Context,
    /// Only the old version.
    Removed,
    /// Only the new version.
    Added,
}

/// A file that was compared as text, because it is broken or has an unknown format.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct TextChange {
    /// Path of the file.
    pub path: String,
    /// Change of the file.
    pub change: Change,
    /// Lines that differ, with line numbers of the file; empty if the text is unreadable.
    pub hunks: Vec<Hunk>,
}
