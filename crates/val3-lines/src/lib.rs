//! Conversion between bytes and lines with columns, for messages to users and for editor protocols.
//!
//! All crates below the binaries count bytes. Only this crate converts bytes to lines and columns, and back. A line
//! ends with `\n`, and a `\r` before it belongs to the line end. A `\r` without `\n` does not end a line, as in git,
//! Vim and Emacs. The exception are positions of the Language Server Protocol, which defines it as a line end.

mod index;
mod wide;

use std::ops::Range;

pub use index::LineIndex;
use memchr::memchr2_iter;

/// Unit of a column.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum ColumnUnit {
    /// Bytes.
    Utf8,
    /// UTF-16 code units, which every language client supports.
    #[default]
    Utf16,
    /// Characters.
    Utf32,
}

/// Counting of columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ColumnCounting {
    /// Unit.
    pub unit: ColumnUnit,
    /// Whether a byte order mark at the start of the text counts. Editors do not display it.
    pub count_mark: bool,
}

impl ColumnCounting {
    /// Characters as displayed by an editor.
    pub const SHOWN_CHARACTERS: Self = Self { unit: ColumnUnit::Utf32, count_mark: false };
    /// All bytes.
    pub const BYTES: Self = Self { unit: ColumnUnit::Utf8, count_mark: true };
}

/// A position in a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct LineColumn {
    /// Line, from 0.
    pub line: u32,
    /// Column, from 0.
    pub column: u32,
}

/// Byte range between two Language Server Protocol positions, in any order, in a text without an index. Only the lines
/// of the positions are indexed, so that edits of large texts are fast. The byte order mark counts.
pub fn range_between(text: &str, one: LineColumn, other: LineColumn, unit: ColumnUnit) -> Range<usize> {
    let first = one.line.min(other.line);
    let start = line_start(text, first);
    let end = line_start(text, one.line.max(other.line).saturating_add(1));
    let lines = LineIndex::for_protocol(text.get(start..end).unwrap_or(""));
    let columns = ColumnCounting { unit, count_mark: true };
    let offset = |at: LineColumn| start + lines.offset(LineColumn { line: at.line - first, ..at }, columns);
    let (one, other) = (offset(one), offset(other));
    one.min(other)..one.max(other)
}

/// Start of a line; after the last line, the end of the text.
fn line_start(text: &str, line: u32) -> usize {
    let Some(before) = line.checked_sub(1) else { return 0 };
    let end = protocol_line_ends(text).nth(before as usize);
    end.map_or(text.len(), |end| end + 1)
}

/// Offsets of the last bytes of the line ends `\n`, `\r\n` and `\r`.
fn protocol_line_ends(text: &str) -> impl Iterator<Item = usize> + Clone {
    let bytes = text.as_bytes();
    let is_last = move |at: &usize| bytes.get(*at) == Some(&b'\n') || bytes.get(at + 1) != Some(&b'\n');
    memchr2_iter(b'\n', b'\r', bytes).filter(is_last)
}

#[cfg(test)]
mod tests;
