//! The parts of a report, without their layout.

use crate::model::{Change, HunkLine};

/// A part of a report.
#[derive(Debug, Clone, PartialEq)]
pub enum Block {
    /// A heading: level 1 names an application or file, level 2 a kind of item.
    Heading {
        /// 1 or 2.
        level: u8,
        /// The text.
        text: String,
        /// An addition in smaller letters, such as a path.
        note: String,
    },
    /// An item that differs.
    Entry(Entry),
    /// Positions with their movements.
    Table(Table),
    /// Lines of code or of a file, in groups that do not follow each other.
    Lines(Vec<Vec<HunkLine>>),
}

/// What a line is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// An added item.
    Added,
    /// A removed item.
    Removed,
    /// A changed item.
    Changed,
    /// An explanation of the item above.
    Note,
    /// Something that needs attention.
    Warning,
}

impl From<Change> for Mark {
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
pub struct Entry {
    /// What happened to it.
    pub mark: Mark,
    /// Its name or declaration; may be empty.
    pub name: String,
    /// The rest of the line; may be empty.
    pub text: String,
}

/// Rows of texts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table {
    /// The titles of the columns. The first column has names, the last has texts, those between have numbers.
    pub titles: Vec<&'static str>,
    /// The rows.
    pub rows: Vec<Row>,
}

/// A row of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    /// What happened to the item of the row.
    pub mark: Mark,
    /// A text for each column.
    pub cells: Vec<String>,
}

/// A heading.
pub(super) fn heading(level: u8, text: &str, note: &str) -> Block {
    Block::Heading { level, text: text.to_owned(), note: note.to_owned() }
}

/// An item that differs.
pub(super) fn entry(mark: Mark, name: &str, text: impl Into<String>) -> Block {
    Block::Entry(Entry { mark, name: name.to_owned(), text: text.into() })
}
