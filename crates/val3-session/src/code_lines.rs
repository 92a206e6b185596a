//! Lines of programs as the controller counts them: within the code of a program, `begin` being line 1.

use std::ops::Range;

use val3_analysis::db::{Database, File};
use val3_analysis::items::faults::{CodeRange, text_faults};
use val3_lines::LineIndex;
use val3_syntax::decode_entities;
use val3_syntax::xml::escaped;

use crate::frame_evaluator::FrameEvaluator;

/// Start and end of a section in which code is not escaped.
const SECTION: [&str; 2] = ["<![CDATA[", "]]>"];

/// Line of a program's code.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CodeLine {
    /// Number within the code, from 1.
    pub number: u32,
    /// Text without the line end.
    pub text: String,
}

/// Lines of a file with the ranges of its programs' code.
pub(crate) struct CodeFile<'d> {
    text: &'d str,
    lines: LineIndex,
    codes: &'d [CodeRange],
}

impl<'d> CodeFile<'d> {
    /// Lines of a file.
    pub(crate) fn of(db: &'d Database, file: File) -> Self {
        let text: &str = file.text(db);
        Self { text, lines: LineIndex::new(text), codes: &text_faults(db, file).codes }
    }

    /// Rows of the code that contains a row, from `begin` to the end.
    fn rows_around(&self, row: u32) -> Option<(u32, u32)> {
        let row_of = |offset| u32::try_from(self.lines.line(offset) + 1).ok();
        let rows = |code: &CodeRange| Some((row_of(code.begin.into())?, row_of(code.range.end().into())?));
        self.codes.iter().filter_map(rows).find(|(first, last)| (*first..=*last).contains(&row))
    }

    /// Byte range of a row without its line end.
    fn range(&self, row: u32) -> Option<Range<usize>> {
        self.lines.line_range(usize::try_from(row).ok()?.checked_sub(1)?)
    }

    /// Byte range of a row between `begin` and the end of the code, without its line end.
    pub(crate) fn inner_line(&self, row: u32) -> Option<Range<usize>> {
        let (first, last) = self.rows_around(row)?;
        self.range(row).filter(|_| first < row && row < last)
    }

    /// Whether the code at the beginning of a row is not escaped.
    fn is_in_section(&self, row: u32) -> bool {
        let before = self.range(row).and_then(|line| self.text.get(..line.start)).unwrap_or_default();
        let [open, close] = SECTION.map(|mark| before.rfind(mark));
        open > close
    }

    /// Code as the file contains it at a row.
    pub(crate) fn encoded(&self, row: u32, code: &str) -> String {
        let [open, close] = SECTION;
        // The end of a section is divided between two sections.
        if self.is_in_section(row) { code.replace(close, &format!("]]{close}{open}>")) } else { escaped(code) }
    }

    /// Code at a row.
    fn code(&self, row: u32) -> Option<String> {
        let text = self.text.get(self.range(row)?)?;
        let [open, close] = SECTION;
        if self.is_in_section(row) {
            return Some(text.replace(&format!("{close}{open}"), ""));
        }
        Some(decode_entities(text).into_owned())
    }
}

impl FrameEvaluator {
    /// Line of the code at a row of a file; `None` outside of code, or for a file of a library that no referencing
    /// application has read.
    #[must_use]
    pub fn code_line(&self, file: &str, row: u32) -> Option<CodeLine> {
        let (db, file) = self.source_file(file)?;
        let code = CodeFile::of(db, file);
        let (first, _) = code.rows_around(row)?;
        Some(CodeLine { number: row - first + 1, text: code.code(row)? })
    }

    /// Row of a file for a line number in the code that contains the row `near`; `None` outside of this code.
    #[must_use]
    pub fn code_row(&self, file: &str, near: u32, number: u32) -> Option<u32> {
        let (db, file) = self.source_file(file)?;
        let code = CodeFile::of(db, file);
        let (first, last) = code.rows_around(near)?;
        first.checked_add(number.checked_sub(1)?).filter(|row| *row <= last)
    }
}
