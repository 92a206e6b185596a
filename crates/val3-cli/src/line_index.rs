//! From an offset in a decoded text to a line, a column and an offset in the stored file.

use std::ops::Range;

use memchr::memchr_iter;
use val3_syntax::encoding::Encoding;

/// A place in a file, counted as in editors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Position {
    /// Line, from 1.
    pub(crate) line: usize,
    /// Column in characters, from 1.
    pub(crate) column: usize,
    /// Bytes of the stored file before this place.
    pub(crate) offset: usize,
}

/// Where the lines and the characters of more than one byte are.
#[derive(Debug)]
pub(crate) struct LineIndex {
    encoding: Encoding,
    /// The text starts with a byte order mark, which takes no column.
    starts_with_mark: bool,
    /// Start of each line; never empty, ascending.
    starts: Vec<usize>,
    /// Characters of more than one byte, ascending.
    wide: Vec<WideCharacter>,
    len: usize,
}

#[derive(Debug, Clone, Copy)]
struct WideCharacter {
    at: usize,
    /// How many bytes more than characters the text has up to the end of this one.
    surplus: usize,
}

impl LineIndex {
    /// Indexes `text`.
    pub(crate) fn new(text: &str, encoding: Encoding) -> Self {
        let ends = memchr_iter(b'\n', text.as_bytes());
        Self {
            encoding,
            starts_with_mark: text.starts_with('\u{feff}'),
            starts: std::iter::once(0).chain(ends.map(|end| end + 1)).collect(),
            wide: wide_characters(text),
            len: text.len(),
        }
    }

    /// The place of a character boundary. An offset beyond the end means the end.
    pub(crate) fn position(&self, offset: usize) -> Position {
        let offset = offset.min(self.len);
        let line = self.line(offset);
        let start = self.line_start(line);
        let mut column = self.characters(offset) - self.characters(start);
        if line == 0 && self.starts_with_mark {
            column = column.saturating_sub(1);
        }
        Position { line: line + 1, column: column + 1, offset: self.stored_offset(offset) }
    }

    /// The line of an offset, from 0.
    pub(crate) fn line(&self, offset: usize) -> usize {
        self.starts.partition_point(|&start| start <= offset) - 1
    }

    /// The text of a line (from 0) with its line end, `None` after the last line.
    pub(crate) fn line_range(&self, line: usize) -> Option<Range<usize>> {
        let start = *self.starts.get(line)?;
        let end = self.starts.get(line + 1).copied().unwrap_or(self.len);
        Some(start..end)
    }

    fn line_start(&self, line: usize) -> usize {
        self.starts.get(line).copied().unwrap_or(self.len)
    }

    /// Characters before an offset.
    fn characters(&self, offset: usize) -> usize {
        let passed = self.wide.partition_point(|wide| wide.at < offset);
        let last = passed.checked_sub(1).and_then(|last| self.wide.get(last));
        offset - last.map_or(0, |wide| wide.surplus)
    }

    fn stored_offset(&self, offset: usize) -> usize {
        match self.encoding {
            Encoding::Utf8 => offset,
            Encoding::Latin1 => self.characters(offset),
        }
    }
}

/// Characters of more than one byte. Texts and lines without any are skipped fast.
fn wide_characters(text: &str) -> Vec<WideCharacter> {
    let (mut wide, mut start, mut surplus) = (Vec::new(), 0, 0);
    if text.is_ascii() {
        return wide;
    }
    for line in text.split_inclusive('\n') {
        if !line.is_ascii() {
            for (at, byte) in line.bytes().enumerate().filter(|(_, byte)| *byte >= 0xC0) {
                surplus += continuation_bytes(byte);
                wide.push(WideCharacter { at: start + at, surplus });
            }
        }
        start += line.len();
    }
    wide
}

/// Bytes that follow the first byte of a UTF-8 character of more than one byte.
fn continuation_bytes(first: u8) -> usize {
    match first {
        0xF0.. => 3,
        0xE0.. => 2,
        _ => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(index: &LineIndex, offset: usize) -> (usize, usize, usize) {
        let position = index.position(offset);
        (position.line, position.column, position.offset)
    }

    #[test]
    fn columns_count_characters() {
        let text = "aé€😀b\nx";
        let index = LineIndex::new(text, Encoding::Utf8);
        let columns: Vec<_> = text.char_indices().map(|(at, _)| place(&index, at)).collect();
        assert_eq!(columns, [(1, 1, 0), (1, 2, 1), (1, 3, 3), (1, 4, 6), (1, 5, 10), (1, 6, 11), (2, 1, 12)]);
    }

    #[test]
    fn offsets_of_latin1_count_characters() {
        let index = LineIndex::new("é\nü=1", Encoding::Latin1);
        assert_eq!(place(&index, 3), (2, 1, 2));
        assert_eq!(place(&index, 5), (2, 2, 3));
    }

    #[test]
    fn a_byte_order_mark_takes_bytes_and_no_column() {
        let index = LineIndex::new("\u{feff}<a>", Encoding::Utf8);
        assert_eq!(place(&index, 3), (1, 1, 3));
        assert_eq!(place(&index, 4), (1, 2, 4));
    }

    #[test]
    fn positions_beyond_the_end_are_at_the_end() {
        let index = LineIndex::new("ab\r\n", Encoding::Utf8);
        assert_eq!(place(&index, 4), (2, 1, 4));
        assert_eq!(place(&index, 99), (2, 1, 4));
        assert_eq!(index.line_range(0), Some(0..4));
        assert_eq!(index.line_range(1), Some(4..4));
        assert_eq!(index.line_range(2), None);
    }

    #[test]
    fn an_empty_text_has_one_line() {
        let index = LineIndex::new("", Encoding::Utf8);
        assert_eq!(place(&index, 0), (1, 1, 0));
    }
}
