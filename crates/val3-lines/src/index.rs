//! Line index of a text.

use std::ops::Range;

use memchr::memchr_iter;

use crate::wide::{WideCharacter, wide_characters};
use crate::{ColumnCounting, ColumnUnit, LineColumn, protocol_line_ends};

const MARK: char = '\u{feff}';

/// Positions of the lines and of the multi-byte characters in a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LineIndex {
    /// Lines, ascending; never empty.
    lines: Vec<LinePosition>,
    /// Multi-byte characters, ascending.
    wide: Vec<WideCharacter>,
    starts_with_mark: bool,
    len: u32,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct LinePosition {
    start: u32,
    /// Start of the line end.
    end: u32,
}

impl LineIndex {
    /// Index of `text`. A `\r` without `\n` does not end a line.
    pub fn new(text: &str) -> Self {
        Self::with_breaks(text, memchr_iter(b'\n', text.as_bytes()))
    }

    /// Index of `text` for the Language Server Protocol, in which `\r` without `\n` also ends a line.
    pub fn for_protocol(text: &str) -> Self {
        Self::with_breaks(text, protocol_line_ends(text))
    }

    fn with_breaks(text: &str, breaks: impl Iterator<Item = usize> + Clone) -> Self {
        let starts = std::iter::once(0).chain(breaks.clone().map(|at| at + 1));
        let lines = starts.zip(breaks.chain([text.len()])).map(|(start, end)| {
            let line = text.get(start..end).unwrap_or("");
            LinePosition { start: small(start), end: small(start + line.trim_end_matches('\r').len()) }
        });
        Self {
            lines: lines.collect(),
            wide: wide_characters(text),
            starts_with_mark: text.starts_with(MARK),
            len: small(text.len()),
        }
    }

    /// Line that contains an offset, from 0. An offset after the end of the text counts as the end.
    pub fn line(&self, offset: usize) -> usize {
        let offset = small(offset);
        self.lines.partition_point(|line| line.start <= offset) - 1
    }

    /// Byte range of a line (from 0) without its line end; `None` after the last line.
    pub fn line_range(&self, line: usize) -> Option<Range<usize>> {
        self.lines.get(line).map(|line| line.start as usize..line.end as usize)
    }

    /// Converts an offset to a position. An offset after the end counts as the end, an offset inside a character as its
    /// start.
    pub fn line_column(&self, offset: usize, columns: ColumnCounting) -> LineColumn {
        let offset = self.boundary(small(offset).min(self.len));
        let line = self.line(offset as usize);
        let start = self.lines.get(line).map_or(0, |line| line.start);
        let column = self.units(offset, columns.unit) - self.units(start, columns.unit);
        LineColumn { line: small(line), column: column.saturating_sub(self.uncounted(line, columns)) }
    }

    /// Converts a position to an offset. A position after the end of a line counts as the line's end, a position inside
    /// a character as its start, and a position after the last line as the end of the text.
    pub fn offset(&self, position: LineColumn, columns: ColumnCounting) -> usize {
        let number = position.line as usize;
        let Some(line) = self.lines.get(number) else { return self.len as usize };
        let (mut at, mut left) = (line.start, position.column.saturating_add(self.uncounted(number, columns)));
        let first = self.wide.partition_point(|wide| wide.at < line.start);
        for wide in self.wide.iter().skip(first).take_while(|wide| wide.at < line.end) {
            let (before, width) = (wide.at - at, wide.width(columns.unit));
            if left < before {
                break;
            }
            if left < before + width {
                return wide.at as usize;
            }
            left -= before + width;
            at = wide.end();
        }
        at.saturating_add(left).min(line.end) as usize
    }

    /// Number of characters before an offset.
    pub fn characters(&self, offset: usize) -> usize {
        self.units(self.boundary(small(offset).min(self.len)), ColumnUnit::Utf32) as usize
    }

    /// Width of the byte order mark, if this line begins with it and it does not count; otherwise 0.
    fn uncounted(&self, line: usize, columns: ColumnCounting) -> u32 {
        let is_uncounted = line == 0 && self.starts_with_mark && !columns.count_mark;
        self.wide.first().filter(|_| is_uncounted).map_or(0, |mark| mark.width(columns.unit))
    }

    /// Number of units before a character boundary.
    fn units(&self, offset: u32, unit: ColumnUnit) -> u32 {
        offset - self.last_wide(offset).map_or(0, |wide| wide.surplus(unit))
    }

    /// Start of the character that contains an offset.
    fn boundary(&self, offset: u32) -> u32 {
        self.last_wide(offset).filter(|wide| offset < wide.end()).map_or(offset, |wide| wide.at)
    }

    /// Last multi-byte character that begins before an offset.
    fn last_wide(&self, offset: u32) -> Option<&WideCharacter> {
        let passed = self.wide.partition_point(|wide| wide.at < offset);
        self.wide.get(passed.checked_sub(1)?)
    }
}

impl Default for LineIndex {
    /// Index for an empty text.
    fn default() -> Self {
        Self::new("")
    }
}

/// Converts to `u32`. Texts are only indexed up to 4 GB.
fn small(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}
