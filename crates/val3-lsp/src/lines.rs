//! Protocol positions in the text of a file.

use tower_lsp::lsp_types::{Position, Range};
use val3_analysis::db::{Db, File};
use val3_lines::{ColumnCounting, ColumnUnit, LineColumn, LineIndex, range_between};
use val3_syntax::{TextRange, TextSize, TextSlice};

/// Line index of a file, memoised until the text changes.
#[salsa::tracked(no_eq)]
pub(crate) fn line_index(db: &dyn Db, file: File) -> LineIndex {
    LineIndex::for_protocol(file.text(db))
}

/// Byte range of a protocol range in an open document.
pub(crate) fn byte_range(text: &str, range: Range, unit: ColumnUnit) -> std::ops::Range<usize> {
    range_between(text, line_column(range.start), line_column(range.end), unit)
}

/// Text with its line index.
pub(crate) struct PositionConverter<'a> {
    text: &'a str,
    index: &'a LineIndex,
    columns: ColumnCounting,
}

impl<'a> PositionConverter<'a> {
    /// `hides_mark` is true for a stored text: an editor's text begins after the byte order mark.
    pub(crate) fn new(text: &'a str, index: &'a LineIndex, unit: ColumnUnit, hides_mark: bool) -> Self {
        Self { text, index, columns: ColumnCounting { unit, count_mark: !hides_mark } }
    }

    /// Converts an offset to a position. An offset after the end of the text returns the end.
    pub(crate) fn position(&self, offset: TextSize) -> Position {
        let LineColumn { line, column } = self.index.line_column(offset.into(), self.columns);
        Position { line, character: column }
    }

    /// Positions of both ends.
    pub(crate) fn range(&self, range: TextRange) -> Range {
        Range { start: self.position(range.start()), end: self.position(range.end()) }
    }

    /// Number of columns in a part of a line.
    pub(crate) fn width(&self, range: TextRange) -> u32 {
        let text = self.text.part(usize::from(range.start())..usize::from(range.end()));
        let width = match self.columns.unit {
            _ if text.is_ascii() => text.len(),
            ColumnUnit::Utf8 => text.len(),
            ColumnUnit::Utf16 => text.encode_utf16().count(),
            ColumnUnit::Utf32 => text.chars().count(),
        };
        u32::try_from(width).unwrap_or(u32::MAX)
    }

    /// Converts a position to an offset. A position after the end of a line returns the line's end, a position inside a
    /// character the character's start.
    pub(crate) fn offset(&self, position: Position) -> TextSize {
        TextSize::try_from(self.index.offset(line_column(position), self.columns)).unwrap_or_default()
    }

    /// Offsets of both ends, in ascending order.
    pub(crate) fn text_range(&self, range: Range) -> TextRange {
        let (start, end) = (self.offset(range.start), self.offset(range.end));
        TextRange::new(start.min(end), end.max(start))
    }
}

fn line_column(position: Position) -> LineColumn {
    LineColumn { line: position.line, column: position.character }
}
