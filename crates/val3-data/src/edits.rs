//! Text edits.

use val3_syntax::{TextEdit, TextRange, TextSize};

/// Edits that do not overlap. Edits at the same offset keep their order.
#[derive(Debug, Default)]
pub(crate) struct Edits {
    edits: Vec<TextEdit>,
}

impl Edits {
    pub(crate) fn replace(&mut self, range: TextRange, text: String) {
        self.edits.push(TextEdit { range, text });
    }

    pub(crate) fn insert(&mut self, at: TextSize, text: String) {
        self.replace(TextRange::empty(at), text);
    }

    /// Edits sorted by offset.
    pub(crate) fn sorted(mut self) -> Vec<TextEdit> {
        self.edits.sort_by_key(|edit| (edit.range.start(), edit.range.end()));
        self.edits
    }
}

/// Combines two lists of edits: `second` applies to the result of `first`. Each list, and the result, is sorted and
/// without overlap.
#[must_use]
pub fn compose(first: &[TextEdit], second: &[TextEdit]) -> Vec<TextEdit> {
    if first.is_empty() {
        return second.to_vec();
    }
    let mut pieces = pieces(first).into_iter().rev().collect::<Vec<_>>();
    let (mut at, mut out) = (TextSize::new(0), Vec::new());
    for edit in second {
        take(&mut pieces, edit.range.start() - at, &mut |piece| out.push(piece));
        out.push(TextPart::New(edit.text.clone()));
        take(&mut pieces, edit.range.len(), &mut |_| {});
        at = edit.range.end();
    }
    out.extend(pieces.into_iter().rev());
    edits(out)
}

/// A part of the edited text.
#[derive(Debug)]
enum TextPart {
    /// From the original text.
    Old(TextRange),
    New(String),
}

impl TextPart {
    fn len(&self) -> TextSize {
        match self {
            Self::Old(range) => range.len(),
            Self::New(text) => TextSize::of(text.as_str()),
        }
    }

    fn split(self, at: TextSize) -> (Self, Self) {
        match self {
            Self::Old(range) => {
                let middle = range.start() + at;
                (Self::Old(TextRange::new(range.start(), middle)), Self::Old(TextRange::new(middle, range.end())))
            }
            Self::New(text) => {
                let (before, after) = text.split_at_checked(usize::from(at)).unwrap_or((&text, ""));
                (Self::New(before.to_owned()), Self::New(after.to_owned()))
            }
        }
    }
}

/// Pieces of the text after `edits`. The last piece is unbounded.
fn pieces(edits: &[TextEdit]) -> Vec<TextPart> {
    let (mut pieces, mut at) = (Vec::new(), TextSize::new(0));
    for edit in edits {
        pieces.push(TextPart::Old(TextRange::new(at, edit.range.start())));
        pieces.push(TextPart::New(edit.text.clone()));
        at = edit.range.end();
    }
    pieces.push(TextPart::Old(TextRange::new(at, TextSize::new(u32::MAX))));
    pieces
}

/// Removes the first `len` bytes of a text, and passes their pieces to `taken`. The pieces are in reverse order.
fn take(pieces: &mut Vec<TextPart>, mut len: TextSize, taken: &mut dyn FnMut(TextPart)) {
    while len > TextSize::new(0) {
        let Some(piece) = pieces.pop() else { return };
        if piece.len() > len {
            let (before, after) = piece.split(len);
            pieces.push(after);
            return taken(before);
        }
        len -= piece.len();
        taken(piece);
    }
}

/// Edits that produce a text of these pieces.
fn edits(pieces: Vec<TextPart>) -> Vec<TextEdit> {
    let mut edits: Vec<TextEdit> = Vec::new();
    let (mut at, mut insert) = (TextSize::new(0), String::new());
    for piece in pieces {
        match piece {
            TextPart::New(text) => insert.push_str(&text),
            TextPart::Old(range) if range.is_empty() => {}
            TextPart::Old(range) => {
                if range.start() > at || !insert.is_empty() {
                    edits
                        .push(TextEdit { range: TextRange::new(at, range.start()), text: std::mem::take(&mut insert) });
                }
                at = range.end();
            }
        }
    }
    edits
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Creates edits for a text with `len` bytes, from distances, lengths and new texts.
    fn some_edits(len: usize, wanted: &[(usize, usize, String)]) -> Vec<TextEdit> {
        let mut at = 0;
        let mut edits = Vec::new();
        for (distance, removed, insert) in wanted {
            let start = (at + distance).min(len);
            let end = (start + removed).min(len);
            let range = TextRange::new(u32::try_from(start).unwrap().into(), u32::try_from(end).unwrap().into());
            edits.push(TextEdit { range, text: insert.clone() });
            at = end + 1;
        }
        edits
    }

    proptest! {
        #[test]
        fn composed_edits_do_the_same(
            text in "[a-z]{0,30}",
            first in proptest::collection::vec((0..8usize, 0..5usize, "[A-Z]{0,4}"), 0..5),
            second in proptest::collection::vec((0..8usize, 0..5usize, "[0-9]{0,4}"), 0..5),
        ) {
            let first = some_edits(text.len(), &first);
            let between = TextEdit::apply_all(&text, &first);
            let second = some_edits(between.len(), &second);
            let expected = TextEdit::apply_all(&between, &second);
            prop_assert_eq!(TextEdit::apply_all(&text, &compose(&first, &second)), expected);
        }
    }
}
