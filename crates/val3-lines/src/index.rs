//! The index of a text.

use std::ops::Range;

use memchr::memchr_iter;

use crate::wide::{WideCharacter, wide_characters};
use crate::{Columns, LineColumn, Unit, protocol_line_ends};

const MARK: char = '\u{feff}';

/// Where the lines and the characters of more than one byte are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LineIndex {
    /// The lines; never empty, ascending.
    lines: Vec<Line>,
    /// Characters of more than one byte, ascending.
    wide: Vec<WideCharacter>,
    starts_with_mark: bool,
    len: u32,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Line {
    start: u32,
    /// The start of its line end.
    end: u32,
}

impl LineIndex {
    /// The index of `text`. A `\r` without `\n` ends no line.
    pub fn new(text: &str) -> Self {
        Self::with_breaks(text, memchr_iter(b'\n', text.as_bytes()))
    }

    /// The index of `text` for the Language Server Protocol: `\r` alone ends a line as well.
    pub fn for_protocol(text: &str) -> Self {
        Self::with_breaks(text, protocol_line_ends(text))
    }

    fn with_breaks(text: &str, breaks: impl Iterator<Item = usize> + Clone) -> Self {
        let starts = std::iter::once(0).chain(breaks.clone().map(|at| at + 1));
        let lines = starts.zip(breaks.chain([text.len()])).map(|(start, end)| {
            let line = text.get(start..end).unwrap_or("");
            Line { start: small(start), end: small(start + line.trim_end_matches('\r').len()) }
        });
        Self {
            lines: lines.collect(),
            wide: wide_characters(text),
            starts_with_mark: text.starts_with(MARK),
            len: small(text.len()),
        }
    }

    /// The line of an offset, from 0. An offset after the end of the text means the end.
    pub fn line(&self, offset: usize) -> usize {
        let offset = small(offset);
        self.lines.partition_point(|line| line.start <= offset) - 1
    }

    /// The bytes of a line (from 0) without its line end, `None` after the last line.
    pub fn line_range(&self, line: usize) -> Option<Range<usize>> {
        self.lines.get(line).map(|line| line.start as usize..line.end as usize)
    }

    /// The position of an offset. An offset after the end means the end, one inside a character its start.
    pub fn line_column(&self, offset: usize, columns: Columns) -> LineColumn {
        let offset = self.boundary(small(offset).min(self.len));
        let line = self.line(offset as usize);
        let start = self.lines.get(line).map_or(0, |line| line.start);
        let column = self.units(offset, columns.unit) - self.units(start, columns.unit);
        LineColumn { line: small(line), column: column.saturating_sub(self.uncounted(line, columns)) }
    }

    /// The offset of a position. After the end of a line it is that end, inside a character its start, after the last
    /// line the end of the text.
    pub fn offset(&self, position: LineColumn, columns: Columns) -> usize {
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

    /// The number of characters before an offset.
    pub fn characters(&self, offset: usize) -> usize {
        self.units(self.boundary(small(offset).min(self.len)), Unit::Utf32) as usize
    }

    /// The columns of the byte order mark, if this line begins with it and it does not count.
    fn uncounted(&self, line: usize, columns: Columns) -> u32 {
        let is_uncounted = line == 0 && self.starts_with_mark && !columns.count_mark;
        self.wide.first().filter(|_| is_uncounted).map_or(0, |mark| mark.width(columns.unit))
    }

    /// Units before a character boundary.
    fn units(&self, offset: u32, unit: Unit) -> u32 {
        offset - self.last_wide(offset).map_or(0, |wide| wide.surplus(unit))
    }

    /// The start of the character that contains an offset.
    fn boundary(&self, offset: u32) -> u32 {
        self.last_wide(offset).filter(|wide| offset < wide.end()).map_or(offset, |wide| wide.at)
    }

    /// The last character of more than one byte that begins before an offset.
    fn last_wide(&self, offset: u32) -> Option<&WideCharacter> {
        let passed = self.wide.partition_point(|wide| wide.at < offset);
        self.wide.get(passed.checked_sub(1)?)
    }
}

impl Default for LineIndex {
    /// The index of an empty text.
    fn default() -> Self {
        Self::new("")
    }
}

/// Texts of more than 4 GB are not indexed to their end.
fn small(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}
