//! Edits and differences of texts.

use std::ops::Range;

use rowan::{TextRange, TextSize};

use crate::lexer::range;
use crate::never::TextSlice;

/// A replacement of a range in a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TextEdit {
    /// Range in the old text.
    pub range: TextRange,
    /// New text.
    pub text: String,
}

impl TextEdit {
    /// Returns the text after the edit. A range is clipped to the text and extended to start at a character boundary.
    pub fn apply(&self, text: &str) -> String {
        let Range { start, end } = self.range_in(text).into();
        let (before, after) = (text.part(..start), text.part(end..));
        [before, &self.text, after].concat()
    }

    /// Returns `text` after these edits, which are sorted, inside the text, and do not overlap.
    pub fn apply_all<'e>(text: &str, edits: impl IntoIterator<Item = &'e Self>) -> String {
        apply_edits(text, edits.into_iter().map(|edit| (edit.range, edit.text.as_str())))
    }

    /// Returns the clipped range in `text`.
    fn range_in(&self, text: &str) -> TextRange {
        let floor = |at: TextSize| text.floor_char_boundary(usize::from(at).min(text.len()));
        range(floor(self.range.start()), floor(self.range.end()))
    }
}

/// Returns `text` with new texts in these ranges, which are sorted, inside the text, and do not overlap.
pub fn apply_edits<'e>(text: &str, edits: impl IntoIterator<Item = (TextRange, &'e str)>) -> String {
    let mut changed = String::with_capacity(text.len());
    let mut done = 0;
    for (range, new) in edits {
        let Range { start, end } = range.into();
        changed.push_str(text.part(done..start));
        changed.push_str(new);
        done = end;
    }
    changed + text.part(done..)
}

/// Changed range in the old text, and the number of inserted bytes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Change {
    pub(crate) range: TextRange,
    pub(crate) inserted: TextSize,
}

impl Change {
    /// Returns the change of `text` by `edit`.
    pub(crate) fn of(edit: &TextEdit, text: &str) -> Self {
        Self { range: edit.range_in(text), inserted: TextSize::of(&edit.text) }
    }

    /// Returns the difference of the texts: the part between their common prefix and common suffix.
    pub(crate) fn between(text: &str, new_text: &str) -> Self {
        let start = text.floor_char_boundary(common_start(text.as_bytes(), new_text.as_bytes()));
        let (rest, new_rest) = (text.part(start..), new_text.part(start..));
        let end = common_end(rest.as_bytes(), new_rest.as_bytes());
        // The common suffix begins with a whole character, which is then a character of both texts.
        let end = text.len() - text.ceil_char_boundary(text.len() - end);
        let inserted = range(start, new_text.len() - end).len();
        Self { range: range(start, text.len() - end), inserted }
    }

    /// Whether nothing changes.
    pub(crate) fn is_none(self) -> bool {
        self.range.is_empty() && self.inserted == TextSize::new(0)
    }

    /// Returns the new offset of a position after the change.
    pub(crate) fn moved(self, at: TextSize) -> TextSize {
        at - self.range.len() + self.inserted
    }
}

/// Number of bytes that are compared in one step.
const STEP: usize = 64;

fn common_start(a: &[u8], b: &[u8]) -> usize {
    let steps = a.chunks_exact(STEP).zip(b.chunks_exact(STEP)).take_while(|(a, b)| a == b).count() * STEP;
    steps + a.iter().skip(steps).zip(b.iter().skip(steps)).take_while(|(a, b)| a == b).count()
}

fn common_end(a: &[u8], b: &[u8]) -> usize {
    let steps = a.rchunks_exact(STEP).zip(b.rchunks_exact(STEP)).take_while(|(a, b)| a == b).count() * STEP;
    steps + a.iter().rev().skip(steps).zip(b.iter().rev().skip(steps)).take_while(|(a, b)| a == b).count()
}
