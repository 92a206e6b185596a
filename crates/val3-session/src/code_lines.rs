//! Lines of programs as the controller counts them: within the code of a program, `begin` being line 1.

use camino::Utf8Path;
use val3_analysis::db::{Database, Sources};
use val3_analysis::items::faults::{CodeRange, text_faults};
use val3_analysis::paths::path_key;
use val3_lines::LineIndex;

use crate::frame_evaluator::FrameEvaluator;

/// Line of a program's code.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CodeLine {
    /// Number within the code, from 1.
    pub number: u32,
    /// Text without the line end.
    pub text: String,
}

/// Lines of a file with the ranges of its programs' code.
struct CodeFile<'d> {
    text: &'d str,
    lines: LineIndex,
    codes: &'d [CodeRange],
}

impl<'d> CodeFile<'d> {
    fn of(db: &'d Database, file: &str) -> Option<Self> {
        let file = Sources::get(db).files(db).get(&path_key(Utf8Path::new(file).as_str())).copied()?;
        let text: &str = file.text(db);
        Some(Self { text, lines: LineIndex::new(text), codes: &text_faults(db, file).codes })
    }

    /// Rows of the code that contains a row, from `begin` to the end.
    fn rows_around(&self, row: u32) -> Option<(u32, u32)> {
        let row_of = |offset| u32::try_from(self.lines.line(offset) + 1).ok();
        let rows = |code: &CodeRange| Some((row_of(code.begin.into())?, row_of(code.range.end().into())?));
        self.codes.iter().filter_map(rows).find(|(first, last)| (*first..=*last).contains(&row))
    }
}

impl FrameEvaluator {
    /// Line of the code at a row of a file; `None` outside of code, or for a file of a library that the application
    /// does not reference.
    #[must_use]
    pub fn code_line(&self, file: &str, row: u32) -> Option<CodeLine> {
        let code = CodeFile::of(self.db(), file)?;
        let (first, _) = code.rows_around(row)?;
        let text = code.text.get(code.lines.line_range(usize::try_from(row).ok()?.checked_sub(1)?)?)?;
        Some(CodeLine { number: row - first + 1, text: text.to_owned() })
    }

    /// Row of a file for a line number in the code that contains the row `near`; `None` outside of this code.
    #[must_use]
    pub fn code_row(&self, file: &str, near: u32, number: u32) -> Option<u32> {
        let code = CodeFile::of(self.db(), file)?;
        let (first, last) = code.rows_around(near)?;
        first.checked_add(number.checked_sub(1)?).filter(|row| *row <= last)
    }
}
