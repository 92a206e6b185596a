//! Edits of texts, and what two texts have in common.

use std::ops::Range;

use rowan::{TextRange, TextSize};

use crate::lexer::range;
use crate::never::Part;

/// A replacement of a range of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edit {
    /// The range of the old text.
    pub range: TextRange,
    /// The replacement.
    pub insert: String,
}

impl Edit {
    /// The text after the edit. A range outside the text is cut to it, one inside of a character starts before it.
    pub fn apply(&self, text: &str) -> String {
        let Range { start, end } = self.range_in(text).into();
        let (before, after) = (text.part(..start), text.part(end..));
        [before, &self.insert, after].concat()
    }

    /// The range that is replaced in `text`.
    fn range_in(&self, text: &str) -> TextRange {
        let floor = |at: TextSize| text.floor_char_boundary(usize::from(at).min(text.len()));
        range(floor(self.range.start()), floor(self.range.end()))
    }
}

/// Where an edit that fits its text took place, and how many bytes came there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Change {
    pub(crate) range: TextRange,
    pub(crate) inserted: TextSize,
}

impl Change {
    /// The edit from `text` to the result of `edit`.
    pub(crate) fn of(edit: &Edit, text: &str) -> Self {
        Self { range: edit.range_in(text), inserted: TextSize::of(&edit.insert) }
    }

    /// The difference of two texts between their common beginning and their common end.
    pub(crate) fn between(text: &str, new_text: &str) -> Self {
        let start = text.floor_char_boundary(common_start(text.as_bytes(), new_text.as_bytes()));
        let (rest, new_rest) = (text.part(start..), new_text.part(start..));
        let end = common_end(rest.as_bytes(), new_rest.as_bytes());
        // The equal ends begin with a whole character, which is then one of both texts.
        let end = text.len() - text.ceil_char_boundary(text.len() - end);
        let inserted = range(start, new_text.len() - end).len();
        Self { range: range(start, text.len() - end), inserted }
    }

    /// Nothing changes.
    pub(crate) fn is_none(self) -> bool {
        self.range.is_empty() && self.inserted == TextSize::new(0)
    }

    /// The new position of an offset after the edit.
    pub(crate) fn moved(self, at: TextSize) -> TextSize {
        at - self.range.len() + self.inserted
    }
}

/// Bytes that are compared at once.
const STEP: usize = 64;

fn common_start(a: &[u8], b: &[u8]) -> usize {
    let steps = a.chunks_exact(STEP).zip(b.chunks_exact(STEP)).take_while(|(a, b)| a == b).count() * STEP;
    steps + a.iter().skip(steps).zip(b.iter().skip(steps)).take_while(|(a, b)| a == b).count()
}

fn common_end(a: &[u8], b: &[u8]) -> usize {
    let steps = a.rchunks_exact(STEP).zip(b.rchunks_exact(STEP)).take_while(|(a, b)| a == b).count() * STEP;
    steps + a.iter().rev().skip(steps).zip(b.iter().rev().skip(steps)).take_while(|(a, b)| a == b).count()
}
