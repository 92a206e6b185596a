//! Characters on a user page.

use val3_machine::screen::{COLUMNS, ROWS};

use super::PutText;

/// Longest time in seconds between `cls` and the same text for which the page counts as redrawn.
const REDRAW: f64 = 0.5;

type Cells = [[char; COLUMNS]; ROWS];

const BLANK: Cells = [[' '; COLUMNS]; ROWS];

/// Characters on a user page, one for each cell.
#[derive(Debug)]
pub(super) struct PageCells {
    cells: Cells,
    /// Time of the last `cls` in seconds, and the characters before it.
    cleared: Option<(f64, Cells)>,
}

impl Default for PageCells {
    fn default() -> Self {
        Self { cells: BLANK, cleared: None }
    }
}

impl PageCells {
    /// Writes text. Returns whether the page differs afterwards. Spaces on an empty line change nothing.
    pub(super) fn write(&mut self, put: PutText<'_>) -> bool {
        let PutText { x, y, text, ends_line, time } = put;
        let before = self.cleared.as_ref().filter(|(cleared, _)| (time - cleared).abs() <= REDRAW);
        let known = before.map_or(self.cells, |(_, cells)| *cells);
        let (mut column, mut row) = (usize::from(x), usize::from(y));
        let mut is_changed = false;
        for character in text.chars() {
            if column >= COLUMNS {
                (column, row) = (0, row + 1);
            }
            if row >= ROWS {
                self.scroll();
                row = ROWS - 1;
                is_changed = true;
            }
            let cell = self.cells.get_mut(row).and_then(|row| row.get_mut(column));
            is_changed |= known.get(row).and_then(|row| row.get(column)) != Some(&character);
            cell.into_iter().for_each(|cell| *cell = character);
            column += 1;
        }
        if ends_line && row + 1 >= ROWS {
            self.scroll();
        }
        is_changed
    }

    /// Empties the page, at a time in seconds.
    pub(super) fn clear(&mut self, time: f64) {
        let shown = std::mem::replace(&mut self.cells, BLANK);
        // A page that is cleared twice is still the page before.
        if shown != BLANK || self.cleared.is_none() {
            self.cleared = Some((time, shown));
        }
    }

    /// Moves all lines up by one.
    fn scroll(&mut self) {
        self.cells.rotate_left(1);
        self.cells.last_mut().into_iter().for_each(|row| *row = [' '; COLUMNS]);
        self.cleared = None;
    }
}
