//! Edits of one text.

use std::ops::Range;

use val3_syntax::Edit;
use val3_syntax::TextRange;

/// Edits that do not overlap; those at one place keep their order.
#[derive(Debug, Default)]
pub(crate) struct Edits {
    edits: Vec<Edit>,
}

impl Edits {
    pub(crate) fn replace(&mut self, range: TextRange, insert: String) {
        self.edits.push(Edit { range, insert });
    }

    /// The edits in the order of their places.
    pub(crate) fn sorted(mut self) -> Vec<Edit> {
        self.edits.sort_by_key(|edit| (edit.range.start(), edit.range.end()));
        self.edits
    }
}

/// A text with `edits`, which are sorted and do not overlap.
#[must_use]
pub fn apply(text: &str, edits: &[Edit]) -> String {
    let mut out = String::with_capacity(text.len());
    let mut done = 0;
    for edit in edits {
        let range = Range::<usize>::from(edit.range);
        out.push_str(text.get(done..range.start).unwrap_or(""));
        out.push_str(&edit.insert);
        done = range.end;
    }
    out + text.get(done..).unwrap_or("")
}
