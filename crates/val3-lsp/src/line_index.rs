//! From offsets to lines and columns as the client counts them, and back.

use ::line_index::{LineCol, LineIndex, WideEncoding, WideLineCol};
use tower_lsp::lsp_types::{Position, Range};
use val3_analysis::db::{Db, File};
use val3_syntax::{TextRange, TextSize};

/// The unit of a column.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum Encoding {
    /// Bytes.
    Utf8,
    /// Units of UTF-16, which every client understands.
    #[default]
    Utf16,
    /// Characters.
    Utf32,
}

/// The lines of a file; kept while its text stays the same, since it is small.
#[salsa::tracked(no_eq)]
pub(crate) fn line_index(db: &dyn Db, file: File) -> LineIndex {
    LineIndex::new(file.text(db))
}

/// The offsets of both ends of a range of an open document. Only the lines of the range are looked at closely.
pub(crate) fn text_range(text: &str, range: Range, encoding: Encoding) -> TextRange {
    let first = range.start.line.min(range.end.line);
    let behind = range.start.line.max(range.end.line).saturating_add(1);
    let start = line_start(text, first);
    let lines = text.get(start..line_start(text, behind)).unwrap_or("");
    let within = |place: Position| Position { line: place.line - first, ..place };
    let range = Range { start: within(range.start), end: within(range.end) };
    let start = TextSize::try_from(start).unwrap_or_default();
    Lines::new(lines, &LineIndex::new(lines), encoding, false).text_range(range) + start
}

/// The start of a line; after the last line, the end of the text.
fn line_start(text: &str, line: u32) -> usize {
    let Some(before) = line.checked_sub(1) else { return 0 };
    let end = memchr::memchr_iter(b'\n', text.as_bytes()).nth(before as usize);
    end.map_or(text.len(), |end| end + 1)
}

const MARK: char = '\u{feff}';

/// A text with its lines.
pub(crate) struct Lines<'a> {
    text: &'a str,
    index: &'a LineIndex,
    encoding: Encoding,
    /// Bytes of a byte order mark that editors do not show.
    hidden: u32,
}

impl<'a> Lines<'a> {
    /// `hides_mark` for a stored text: the text that an editor shows begins after the byte order mark.
    pub(crate) fn new(text: &'a str, index: &'a LineIndex, encoding: Encoding, hides_mark: bool) -> Self {
        let hidden = if hides_mark && text.starts_with(MARK) { MARK.len_utf8() } else { 0 };
        Self { text, index, encoding, hidden: u32::try_from(hidden).unwrap_or(0) }
    }

    /// The position of an offset. An offset after the end means the end.
    pub(crate) fn position(&self, offset: TextSize) -> Position {
        let offset = offset.min(self.end());
        let offset = TextSize::try_from(self.text.floor_char_boundary(offset.into())).unwrap_or(offset);
        let at = self.index.line_col(offset);
        let column = match self.wide() {
            None => at.col,
            Some(wide) => self.index.to_wide(wide, at).map_or(at.col, |at| at.col),
        };
        Position { line: at.line, character: column - self.hidden_columns(at.line).min(column) }
    }

    /// The places of both ends.
    pub(crate) fn range(&self, range: TextRange) -> Range {
        Range { start: self.position(range.start()), end: self.position(range.end()) }
    }

    /// The columns that a part of a line takes.
    pub(crate) fn width(&self, range: TextRange) -> u32 {
        let text = self.text.get(usize::from(range.start())..usize::from(range.end())).unwrap_or("");
        let width = match self.encoding {
            _ if text.is_ascii() => text.len(),
            Encoding::Utf8 => text.len(),
            Encoding::Utf16 => text.encode_utf16().count(),
            Encoding::Utf32 => text.chars().count(),
        };
        u32::try_from(width).unwrap_or(u32::MAX)
    }

    /// The offset of a position. After the end of a line it is that end, inside a character its start.
    pub(crate) fn offset(&self, position: Position) -> TextSize {
        let Some(line) = self.index.line(position.line) else { return self.end() };
        let column = position.character.saturating_add(self.hidden_columns(position.line));
        let column = match self.wide() {
            None => Some(LineCol { line: position.line, col: column }),
            Some(wide) => self.index.to_utf8(wide, WideLineCol { line: position.line, col: column }),
        };
        let end = self.end_of_line(line);
        let offset =
            column.and_then(|column| line.start().checked_add(column.col.into())).map_or(end, |at| at.min(end));
        TextSize::try_from(self.text.floor_char_boundary(offset.into())).unwrap_or(offset)
    }

    /// The offsets of both ends, in order.
    pub(crate) fn text_range(&self, range: Range) -> TextRange {
        let (start, end) = (self.offset(range.start), self.offset(range.end));
        TextRange::new(start.min(end), end.max(start))
    }

    /// The end of a line, before its line end.
    fn end_of_line(&self, line: TextRange) -> TextSize {
        let text = self.text.get(usize::from(line.start())..usize::from(line.end())).unwrap_or("");
        let shown = text.trim_end_matches(['\n', '\r']);
        line.start() + TextSize::of(shown)
    }

    fn end(&self) -> TextSize {
        TextSize::of(self.text)
    }

    fn hidden_columns(&self, line: u32) -> u32 {
        match self.encoding {
            _ if line > 0 || self.hidden == 0 => 0,
            Encoding::Utf8 => self.hidden,
            Encoding::Utf16 | Encoding::Utf32 => 1,
        }
    }

    fn wide(&self) -> Option<WideEncoding> {
        match self.encoding {
            Encoding::Utf8 => None,
            Encoding::Utf16 => Some(WideEncoding::Utf16),
            Encoding::Utf32 => Some(WideEncoding::Utf32),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "aé€😀b\r\nx\n";

    fn columns(encoding: Encoding) -> Vec<u32> {
        let index = LineIndex::new(TEXT);
        let lines = Lines::new(TEXT, &index, encoding, false);
        let places: Vec<Position> = TEXT.char_indices().map(|(at, _)| lines.position(size(at))).collect();
        for ((at, letter), place) in TEXT.char_indices().zip(&places) {
            if letter != '\n' {
                assert_eq!(lines.offset(*place), size(at));
            }
        }
        let starts = TEXT.char_indices().map(|(at, letter)| (lines.position(size(at)), lines.width(range(at, letter))));
        assert!(
            starts.take(4).zip(&places[1..]).all(|((start, width), next)| start.character + width == next.character)
        );
        places.iter().take(5).map(|place| place.character).collect()
    }

    fn range(at: usize, letter: char) -> TextRange {
        TextRange::at(size(at), TextSize::of(letter))
    }

    fn size(at: usize) -> TextSize {
        TextSize::try_from(at).unwrap()
    }

    #[test]
    fn columns_count_in_the_agreed_encoding() {
        assert_eq!(columns(Encoding::Utf8), [0, 1, 3, 6, 10]);
        assert_eq!(columns(Encoding::Utf16), [0, 1, 2, 3, 5]);
        assert_eq!(columns(Encoding::Utf32), [0, 1, 2, 3, 4]);
    }

    #[test]
    fn positions_that_do_not_exist_are_moved_into_the_text() {
        let index = LineIndex::new(TEXT);
        let lines = Lines::new(TEXT, &index, Encoding::Utf16, false);
        let offset = |line, character| usize::from(lines.offset(Position { line, character }));
        assert_eq!(offset(0, 99), TEXT.find('\r').unwrap());
        assert_eq!(offset(0, u32::MAX), TEXT.find('\r').unwrap());
        assert_eq!(offset(9, 0), TEXT.len());
        assert_eq!(offset(2, 5), TEXT.len());
        // Half of a surrogate pair.
        assert!(TEXT.is_char_boundary(offset(0, 4)));
    }

    #[test]
    fn editors_do_not_show_the_byte_order_mark() {
        let text = "\u{feff}<a>";
        let index = LineIndex::new(text);
        for encoding in [Encoding::Utf8, Encoding::Utf16] {
            let stored = Lines::new(text, &index, encoding, true);
            assert_eq!(stored.position(size(3)).character, 0);
            assert_eq!(stored.offset(Position { line: 0, character: 1 }), size(4));
        }
        assert_eq!(Lines::new(text, &index, Encoding::Utf16, false).position(size(3)).character, 1);
    }
}
