//! User page: 14 lines of 40 columns, a cursor and a title (4.1).

use super::row::{ScreenCell, ScreenRow};
use super::text_mode::TextMode;
use super::width::columns_of;

/// Columns of a page.
pub const COLUMNS: usize = 40;

/// Lines of a page.
pub const ROWS: usize = 14;

/// Position on a page; (0,0) is the upper left corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CursorCell {
    /// Column, 0 to 39. After writing the last column, the cursor is at 40, and only the next character goes to the
    /// next line. A menu of 40 columns therefore fits the last line, and `putln` of a full line adds no empty line.
    pub column: usize,
    /// Line, 0 to 13.
    pub row: usize,
}

/// Content of a `screen` variable: text, cursor, text mode and title.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PageContent {
    rows: [ScreenRow; ROWS],
    cursor: CursorCell,
    mode: TextMode,
    title: String,
}

impl PageContent {
    /// Position of the next character.
    #[must_use]
    pub fn cursor(&self) -> CursorCell {
        self.cursor
    }

    /// Complete title; the pendant displays 40 columns.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Text mode of the next characters.
    #[must_use]
    pub fn mode(&self) -> TextMode {
        self.mode
    }

    /// The 14 lines as text, without the blanks at their ends.
    pub fn lines(&self) -> impl Iterator<Item = String> {
        self.rows.iter().map(ScreenRow::text)
    }

    /// The 14 lines as cells, one for each column. A line without a write has no cells, and is blank.
    pub fn cells(&self) -> impl Iterator<Item = &[ScreenCell]> {
        self.rows.iter().map(ScreenRow::cells)
    }

    /// Changes the title; the cursor stays (`title`).
    pub(super) fn set_title(&mut self, title: &str) {
        title.clone_into(&mut self.title);
    }

    /// Sets the appearance of text that is written from now on (`setTextMode`).
    pub(super) fn set_mode(&mut self, mode: TextMode) {
        self.mode = mode;
    }

    /// Moves the cursor to column `x` modulo 40 and line `y` modulo 14 (`gotoxy`).
    ///
    /// Numbers are rounded like an index; a negative number counts from the other edge.
    pub(super) fn go_to(&mut self, x: f64, y: f64) {
        self.cursor = CursorCell { column: wrapped(x, COLUMNS), row: wrapped(y, ROWS) };
    }

    /// Clears the page and moves the cursor to the corner (`cls`). Title and text mode stay.
    pub(super) fn clear(&mut self) {
        self.rows = Default::default();
        self.cursor = CursorCell::default();
    }

    /// Writes `text` at the cursor, with line breaks at the right edge and scrolling at the end of the page (`put`).
    /// Returns the start position.
    pub(super) fn put(&mut self, text: &str) -> CursorCell {
        if let Some(first) = text.chars().next() {
            self.make_room(columns_of(first));
        }
        let start = self.cursor;
        for character in text.chars() {
            let columns = columns_of(character);
            self.make_room(columns);
            let mode = self.mode;
            self.cursor = self.write(self.cursor, character, columns, mode);
        }
        start
    }

    /// Moves the cursor to the beginning of the next line; on the last line the page scrolls (`putln`).
    pub(super) fn end_line(&mut self) {
        self.cursor.column = 0;
        if self.cursor.row + 1 < ROWS {
            self.cursor.row += 1;
        } else {
            self.rows.rotate_left(1);
            if let Some(last) = self.rows.last_mut() {
                *last = ScreenRow::default();
            }
        }
    }

    /// Writes `text` at `start` and in the lines below; the part beyond the page is not shown. The cursor stays and
    /// nothing scrolls.
    pub(super) fn write_over(&mut self, start: CursorCell, text: &str) {
        let mut at = start;
        for character in text.chars() {
            let columns = columns_of(character);
            if at.column + columns > COLUMNS {
                at = CursorCell { column: 0, row: at.row + 1 };
            }
            let mode = self.mode;
            at = self.write(at, character, columns, mode);
        }
    }

    /// Starts a new line if a character of `columns` columns does not fit into this one.
    fn make_room(&mut self, columns: usize) {
        if self.cursor.column + columns > COLUMNS {
            self.end_line();
        }
    }

    fn write(&mut self, at: CursorCell, character: char, columns: usize, mode: TextMode) -> CursorCell {
        match self.rows.get_mut(at.row) {
            Some(row) if columns == 0 => row.combine(at.column, character),
            Some(row) => row.write(at.column, character, columns, mode),
            None => {}
        }
        CursorCell { column: at.column + columns, ..at }
    }
}

fn wrapped(number: f64, size: usize) -> usize {
    (number + 0.5).floor().rem_euclid(size as f64) as usize
}

#[cfg(test)]
mod tests;
