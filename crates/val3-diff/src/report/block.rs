//! Report blocks, independent of layout.

use crate::model::{Change, HunkLine};

/// A part of a report.
#[derive(Debug, Clone, PartialEq)]
pub enum Block {
    /// A heading: level 1 names an application or file, level 2 a kind of item.
    Heading {
        /// 1 or 2.
        level: u8,
        /// Heading text.
        text: String,
        /// Addition in smaller letters, such as a path.
        note: String,
    },
    /// An item that differs.
    Entry(ReportItem),
    /// Positions with their movements.
    Table(TextTable),
    /// Lines of code or of a file, in groups of consecutive lines.
    Lines(Vec<Vec<HunkLine>>),
}

/// Meaning of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReportMark {
    /// An added item.
    Added,
    /// A removed item.
    Removed,
    /// A changed item.
    Changed,
    /// An explanation of the item above.
    Note,
    /// A warning.
    Warning,
}

impl From<Change> for ReportMark {
    fn from(change: Change) -> Self {
        match change {
            Change::Added => Self::Added,
            Change::Removed => Self::Removed,
            Change::Changed => Self::Changed,
        }
    }
}

/// An item that differs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReportItem {
    /// Change of the item.
    pub mark: ReportMark,
    /// Name or declaration; may be empty.
    pub name: String,
    /// Rest of the line; may be empty.
    pub text: String,
}

/// A table of texts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TextTable {
    /// Titles of the columns. The first column contains names, the last contains texts, and the others contain numbers.
    pub titles: Vec<&'static str>,
    /// The rows.
    pub rows: Vec<ReportRow>,
}

/// A row of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReportRow {
    /// Change of the item in the row.
    pub mark: ReportMark,
    /// Text for each column.
    pub cells: Vec<String>,
}

/// Creates a heading.
pub(super) fn heading(level: u8, text: &str, note: &str) -> Block {
    Block::Heading { level, text: text.to_owned(), note: note.to_owned() }
}

/// Creates an entry for an item that differs.
pub(super) fn entry(mark: ReportMark, name: &str, text: impl Into<String>) -> Block {
    Block::Entry(ReportItem { mark, name: name.to_owned(), text: text.into() })
}
