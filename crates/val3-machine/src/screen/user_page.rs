//! User page with its keys: the context of a `screen` variable (4.2).

use std::collections::VecDeque;

use val3_lang::ports::{InputKind, InputResult};

use super::ids::ReadingId;
use super::page::{CursorCell, PageContent};
use super::reading::{KeyEffect, ScreenReading};
use super::width::display_columns;

/// Page, the keys that it has received, and the `get` instructions that wait for a key.
#[derive(Debug, Clone, Default)]
pub(super) struct UserScreen {
    pub(super) name: String,
    pub(super) page: PageContent,
    pub(super) last_key: Option<u16>,
    readings: VecDeque<Pending>,
}

/// Waiting `get`.
#[derive(Debug, Clone)]
struct Pending {
    id: ReadingId,
    reading: ScreenReading,
    at: CursorCell,
    /// Maximum text width so far, in columns: when the text becomes shorter, the rest is blanked.
    widest: usize,
}

/// Text that a `get` writes on its page.
pub(super) type Echo = (CursorCell, String);

impl UserScreen {
    pub(super) fn new(name: &str) -> Self {
        Self { name: name.to_owned(), ..Self::default() }
    }

    pub(super) fn is_read(&self) -> bool {
        !self.readings.is_empty()
    }

    /// Begins a `get` at the cursor, which shows its text there.
    pub(super) fn begin(&mut self, id: ReadingId, asked: InputKind) -> Option<Echo> {
        let mut pending = Pending { id, reading: ScreenReading::new(asked), at: self.page.cursor(), widest: 0 };
        let echo = pending.show(&mut self.page);
        self.readings.push_back(pending);
        echo
    }

    /// Cancels a `get`; its text stays on the page.
    pub(super) fn cancel(&mut self, id: ReadingId) {
        self.readings.retain(|pending| pending.id != id);
    }

    /// Processes a key that is pressed while the page is shown. Of several `get` on one page the oldest one receives
    /// it.
    pub(super) fn press(&mut self, key: u16) -> (Option<Echo>, Option<(ReadingId, InputResult)>) {
        self.last_key = Some(key);
        let Some(first) = self.readings.front_mut() else { return (None, None) };
        match first.reading.press(key) {
            KeyEffect::Nothing => (None, None),
            KeyEffect::Edited => (first.show(&mut self.page), None),
            KeyEffect::Ended(answer) => {
                let (id, echo) = (first.id, first.show(&mut self.page));
                self.readings.pop_front();
                (echo, Some((id, answer)))
            }
        }
    }
}

impl Pending {
    /// Writes the text at the start position of the `get`; the cursor of the page stays.
    fn show(&mut self, page: &mut PageContent) -> Option<Echo> {
        let text = self.reading.shown()?;
        let columns = display_columns(&text);
        self.widest = self.widest.max(columns);
        let padded = text + &" ".repeat(self.widest - columns);
        page.write_over(self.at, &padded);
        Some((self.at, padded))
    }
}
