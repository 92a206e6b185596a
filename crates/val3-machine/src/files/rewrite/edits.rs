//! Edits of one text.

use std::ops::Range;

use val3_syntax::TextRange;

/// Edits that do not overlap; those at one place keep their order.
#[derive(Debug, Default)]
pub(super) struct Edits {
    edits: Vec<(TextRange, String)>,
}

impl Edits {
    pub(super) fn replace(&mut self, range: TextRange, text: String) {
        self.edits.push((range, text));
    }

    /// The text with all edits.
    pub(super) fn apply(mut self, text: &str) -> String {
        self.edits.sort_by_key(|(range, _)| (range.start(), range.end()));
        let mut out = String::with_capacity(text.len());
        let mut done = 0;
        for (range, new) in &self.edits {
            let range = Range::<usize>::from(*range);
            out.push_str(text.get(done..range.start).unwrap_or(""));
            out.push_str(new);
            done = range.end;
        }
        out + text.get(done..).unwrap_or("")
    }
}
