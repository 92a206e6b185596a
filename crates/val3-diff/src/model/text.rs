//! Lines that differ.

use serde::Serialize;

use super::change::Change;

/// Lines that differ, with their surroundings.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Hunk {
    /// The first old line, from 1; the line before if there are none.
    pub old_start: usize,
    /// Number of old lines.
    pub old_lines: usize,
    /// The first new line, from 1; the line before if there are none.
    pub new_start: usize,
    /// Number of new lines.
    pub new_lines: usize,
    /// The lines.
    pub lines: Vec<HunkLine>,
}

/// A line of a hunk.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct HunkLine {
    /// Which version has it.
    pub kind: LineKind,
    /// Its number in the version that has it, from 1; in the new version if both have it.
    pub number: usize,
    /// The text without its line end.
    pub text: String,
}

/// Which version has a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum LineKind {
    /// Both.
    Context,
    /// The old one.
    Removed,
    /// The new one.
    Added,
}

/// A file that was compared as text, because it is broken or of an unknown form.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct TextChange {
    /// The path.
    pub path: String,
    /// What happened to it.
    pub change: Change,
    /// The lines that differ, in the numbers of the file. Empty if the text cannot be read.
    pub hunks: Vec<Hunk>,
}
