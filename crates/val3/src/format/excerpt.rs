//! Source lines shown with a finding.
//!
//! A file may contain a line of many megabytes, so at most a window of each line is shown. For a range that spans
//! several lines, only the first line is shown.

use std::ops::Range;
use std::ptr;

use codespan_reporting::files::{Error, Files};

use crate::report::{ReportRange, SourceFile};

/// Maximum length of a line that is not cut, in bytes.
const LONGEST_LINE: usize = 240;
/// Number of bytes shown before the marked range in a cut line.
const BEFORE: usize = 80;

/// Visible parts of the lines to which a finding refers.
#[derive(Debug, Default)]
pub(crate) struct Excerpt<'a> {
    windows: Vec<Window<'a>>,
}

/// A file, compared by address.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FileId<'a>(&'a SourceFile);

impl PartialEq for FileId<'_> {
    fn eq(&self, other: &Self) -> bool {
        ptr::eq(self.0, other.0)
    }
}

#[derive(Debug)]
struct Window<'a> {
    file: FileId<'a>,
    line: usize,
    range: Range<usize>,
}

impl<'a> Excerpt<'a> {
    /// Makes the start of `place` visible. `None` if its line is already cut and the visible part does not contain
    /// `place`.
    pub(crate) fn show(&mut self, place: &'a ReportRange) -> Option<(FileId<'a>, Range<usize>)> {
        let file = FileId(&place.file);
        let line = place.file.lines.line(place.range.start);
        let shown = self.window(file, line);
        let range = match shown {
            Some(range) => range,
            None => self.open(file, line, place.range.start),
        };
        let start = place.range.start.min(content(file.0, line).end);
        if start < range.start || start > range.end {
            return None;
        }
        Some((file, start..place.range.end.clamp(start, range.end)))
    }

    fn window(&self, file: FileId<'a>, line: usize) -> Option<Range<usize>> {
        let same = |window: &&Window<'a>| window.file == file && window.line == line;
        self.windows.iter().find(same).map(|window| window.range.clone())
    }

    fn open(&mut self, file: FileId<'a>, line: usize, focus: usize) -> Range<usize> {
        let range = cut(file.0, line, focus);
        self.windows.push(Window { file, line, range: range.clone() });
        range
    }
}

/// Range of a line without its line end; empty after the last line.
fn content(file: &SourceFile, line: usize) -> Range<usize> {
    let end = file.text.len();
    file.lines.line_range(line).unwrap_or(end..end)
}

/// Range of the visible part of a line, around `focus`.
fn cut(file: &SourceFile, line: usize, focus: usize) -> Range<usize> {
    let content = content(file, line);
    if content.len() <= LONGEST_LINE {
        return content;
    }
    let start = file.text.floor_char_boundary(focus.min(content.end).saturating_sub(BEFORE));
    let start = start.max(content.start);
    let end = file.text.floor_char_boundary(start + LONGEST_LINE);
    start..end.min(content.end)
}

impl<'a, 's: 'a> Files<'a> for Excerpt<'s> {
    type FileId = FileId<'s>;
    type Name = &'a str;
    type Source = &'a str;

    fn name(&'a self, id: Self::FileId) -> Result<&'a str, Error> {
        Ok(&id.0.shown)
    }

    fn source(&'a self, id: Self::FileId) -> Result<&'a str, Error> {
        Ok(&id.0.text)
    }

    fn line_index(&'a self, id: Self::FileId, offset: usize) -> Result<usize, Error> {
        Ok(id.0.lines.line(offset))
    }

    fn column_number(&'a self, id: Self::FileId, _line: usize, offset: usize) -> Result<usize, Error> {
        Ok(id.0.position(offset).column)
    }

    fn line_range(&'a self, id: Self::FileId, line: usize) -> Result<Range<usize>, Error> {
        let start = content(id.0, line).start;
        Ok(self.window(id, line).unwrap_or_else(|| cut(id.0, line, start)))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use val3_syntax::encoding::Encoding;

    use super::*;

    fn place(text: &str, range: Range<usize>) -> ReportRange {
        let file = Arc::new(SourceFile::new("a.pgx", text.into(), Encoding::Utf8));
        ReportRange { file, range }
    }

    #[test]
    fn a_long_line_is_cut_around_the_place() {
        let text = format!("{}x=1{}", "é".repeat(5_000), "ü".repeat(5_000));
        let place = place(&text, 10_000..10_003);
        let mut excerpt = Excerpt::default();
        let (file, range) = excerpt.show(&place).unwrap();
        assert_eq!(range, 10_000..10_003);
        let shown = text.get(excerpt.line_range(file, 0).unwrap()).unwrap();
        assert!(shown.contains("x=1") && shown.len() <= LONGEST_LINE, "{shown}");
    }

    #[test]
    fn a_second_place_outside_the_window_is_not_shown() {
        let first = place(&"a".repeat(1_000), 900..905);
        let far = ReportRange { file: Arc::clone(&first.file), range: 10..11 };
        let mut excerpt = Excerpt::default();
        assert!(excerpt.show(&first).is_some());
        assert!(excerpt.show(&far).is_none());
    }

    #[test]
    fn only_the_first_of_several_lines_is_marked() {
        let place = place("if a\r\n  b\r\n", 3..9);
        assert_eq!(Excerpt::default().show(&place).unwrap().1, 3..4);
    }

    #[test]
    fn the_end_of_the_file_can_be_shown() {
        let place = place("a\n", 2..2);
        assert_eq!(Excerpt::default().show(&place).unwrap().1, 2..2);
    }
}
