//! Line of a page: cells with one column each.

use smol_str::SmolStr;

use super::page::COLUMNS;
use super::text_mode::TextMode;

/// Size in bytes of a character with its combining marks, from which on further marks are dropped.
const LONGEST_CELL: usize = 16;

/// Content of a column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ScreenCell {
    /// The character with its combining marks; empty for the right half of a wide character.
    pub text: SmolStr,
    /// Appearance.
    pub mode: TextMode,
}

impl ScreenCell {
    /// Content of columns before the first write.
    pub const BLANK: Self = Self { text: SmolStr::new_inline(" "), mode: TextMode::Standard };

    /// The right half of a wide character.
    fn right_half(mode: TextMode) -> Self {
        Self { text: SmolStr::new_inline(""), mode }
    }

    fn is_right_half(&self) -> bool {
        self.text.is_empty()
    }
}

/// Line of a page; it has no cells until it is written.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct ScreenRow {
    cells: Vec<ScreenCell>,
}

impl ScreenRow {
    /// One cell for each column; none before the first write.
    pub(super) fn cells(&self) -> &[ScreenCell] {
        &self.cells
    }

    /// Text without the blanks at the end.
    pub(super) fn text(&self) -> String {
        let text: String = self.cells.iter().map(|cell| cell.text.as_str()).collect();
        text.trim_end_matches(' ').to_owned()
    }

    /// Writes a character with `columns` columns at `column`. The rest of a wide character that it cuts becomes blank.
    pub(super) fn write(&mut self, column: usize, character: char, columns: usize, mode: TextMode) {
        if self.cells.len() < column + columns {
            self.cells.resize(COLUMNS.max(column + columns), ScreenCell::BLANK);
        }
        self.split(column);
        self.split(column + columns);
        let mut encoded = [0; 4];
        let shown = if character.is_control() { ' ' } else { character };
        let text = SmolStr::new(shown.encode_utf8(&mut encoded));
        let written = [ScreenCell { text, mode }, ScreenCell::right_half(mode)];
        for (cell, new) in self.cells.iter_mut().skip(column).zip(written.into_iter().take(columns)) {
            *cell = new;
        }
    }

    /// Adds a combining mark to the character that ends before `column`, unless it has many marks already.
    pub(super) fn combine(&mut self, column: usize, mark: char) {
        let before = self.cells.iter_mut().take(column).rev().find(|cell| !cell.is_right_half());
        if let Some(cell) = before.filter(|cell| cell.text.len() < LONGEST_CELL) {
            cell.text = format!("{}{mark}", cell.text).into();
        }
    }

    /// Blanks the wide character that covers the boundary before `column`.
    fn split(&mut self, column: usize) {
        if !self.cells.get(column).is_some_and(ScreenCell::is_right_half) {
            return;
        }
        for cell in self.cells.iter_mut().skip(column.saturating_sub(1)).take(2) {
            *cell = ScreenCell { mode: cell.mode, ..ScreenCell::BLANK };
        }
    }
}
