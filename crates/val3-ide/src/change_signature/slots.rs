//! Reordering of lists: call arguments, or elements in an XML list.

use val3_syntax::{TextRange, TextSize, text_at};

use crate::xml_list::whole_line;

/// Edit in a file.
pub(super) type SlotEdit = (TextRange, String);

/// An element of the list after the change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum ListSlot {
    /// An existing element, by its index.
    Kept(usize),
    /// A new element, as source text.
    Added(String),
}

impl ListSlot {
    /// Text of a new element.
    pub(super) fn added(&self) -> Option<&str> {
        if let Self::Added(text) = self { Some(text) } else { None }
    }
}

/// Text that is removed together with an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Removal {
    /// The separator before the element, or after the first element.
    Separator,
    /// The element's line, if it contains nothing else.
    Line,
}

/// A list in the text of a file. Elements are moved as a unit; the text between them is unchanged.
pub(super) struct Slots<'a> {
    pub(super) text: &'a str,
    /// Ranges of the elements, in the order of the text.
    pub(super) entries: &'a [TextRange],
    /// Edits inside elements, which move with them.
    pub(super) inner: &'a [SlotEdit],
    /// Text between an added element and its neighbour.
    pub(super) separator: &'a str,
    pub(super) removal: Removal,
}

impl Slots<'_> {
    /// Edits that produce this order, sorted and without overlap. An empty list has no edits.
    pub(super) fn edits(&self, order: &[ListSlot]) -> Vec<SlotEdit> {
        let (kept, mut removed): (Vec<usize>, Vec<usize>) =
            (0..self.entries.len()).partition(|index| order.contains(&ListSlot::Kept(*index)));
        let mut edits = Vec::new();
        if kept.is_empty() && !order.is_empty() && !removed.is_empty() {
            edits.push((self.range(0), self.joined(order)));
            removed.remove(0);
        } else {
            edits.extend(self.placed(order, &kept));
        }
        edits.extend(removed.into_iter().map(|index| (self.removed(index, kept.first().copied()), String::new())));
        merged(edits)
    }

    /// Kept elements at their new positions, with the added elements between them.
    fn placed(&self, order: &[ListSlot], kept: &[usize]) -> Vec<SlotEdit> {
        let mut edits = Vec::new();
        let mut slots = kept.iter().copied();
        let mut last: Option<usize> = None;
        for entry in order {
            match (entry, last) {
                (ListSlot::Kept(index), _) => {
                    let Some(slot) = slots.next() else { break };
                    edits.extend(self.moved(*index, slot));
                    last = Some(slot);
                }
                (ListSlot::Added(new), Some(slot)) => {
                    edits.push((TextRange::empty(self.range(slot).end()), format!("{}{new}", self.separator)));
                }
                (ListSlot::Added(new), None) => {
                    let Some(first) = kept.first() else { break };
                    edits.push((TextRange::empty(self.range(*first).start()), format!("{new}{}", self.separator)));
                }
            }
        }
        edits
    }

    /// Moves the element `index` to the position of the element `slot`.
    fn moved(&self, index: usize, slot: usize) -> Vec<SlotEdit> {
        let from = self.range(index);
        let inner = self.inner.iter().filter(|(range, _)| from.contains_range(*range));
        if index == slot {
            return inner.cloned().collect();
        }
        let mut text = self.slice(from).to_owned();
        let start = usize::from(from.start());
        for (range, new) in inner.rev() {
            text.replace_range(usize::from(range.start()) - start..usize::from(range.end()) - start, new);
        }
        vec![(self.range(slot), text)]
    }

    fn removed(&self, index: usize, first_kept: Option<usize>) -> TextRange {
        let range = self.range(index);
        match (self.removal, index.checked_sub(1)) {
            (Removal::Line, _) => whole_line(self.text, range),
            (Removal::Separator, _) if first_kept.is_some_and(|first| index < first) => {
                TextRange::new(range.start(), self.range(index + 1).start())
            }
            (Removal::Separator, Some(before)) => TextRange::new(self.range(before).end(), range.end()),
            (Removal::Separator, None) => range,
        }
    }

    fn joined(&self, order: &[ListSlot]) -> String {
        order.iter().filter_map(ListSlot::added).collect::<Vec<_>>().join(self.separator)
    }

    fn range(&self, index: usize) -> TextRange {
        self.entries.get(index).copied().unwrap_or(TextRange::empty(TextSize::new(0)))
    }

    fn slice(&self, range: TextRange) -> &str {
        text_at(self.text, range)
    }
}

/// Sorts the edits by position, and joins adjacent edits.
fn merged(mut edits: Vec<SlotEdit>) -> Vec<SlotEdit> {
    edits.sort_by_key(|(range, _)| (range.start(), range.end()));
    let mut merged: Vec<SlotEdit> = Vec::new();
    for (range, text) in edits {
        match merged.last_mut() {
            Some((last, so_far)) if last.end() >= range.start() => {
                *last = last.cover(range);
                so_far.push_str(&text);
            }
            _ => merged.push((range, text)),
        }
    }
    merged
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Arguments of `p(…)` after a change: digits are indexes, letters are new arguments.
    fn arguments(text: &str, order: &str) -> String {
        let (start, end) = (text.find('(').unwrap() + 1, text.find(')').unwrap());
        let mut entries = Vec::new();
        let mut at = start;
        for part in text[start..end].split(',').filter(|part| !part.trim().is_empty()) {
            let inside = at + part.len() - part.trim_start().len();
            let range = TextRange::at(u32::try_from(inside).unwrap().into(), TextSize::of(part.trim()));
            entries.push(range);
            at += part.len() + 1;
        }
        let separator = if text.contains(", ") { ", " } else { "," };
        let slots = Slots { text, entries: &entries, inner: &[], separator, removal: Removal::Separator };
        let order = order.chars().map(|letter| match letter.to_digit(10) {
            Some(index) => ListSlot::Kept(index as usize),
            None => ListSlot::Added(letter.to_string()),
        });
        let mut changed = text.to_owned();
        for (range, new) in slots.edits(&order.collect::<Vec<_>>()).into_iter().rev() {
            changed.replace_range(std::ops::Range::<usize>::from(range), &new);
        }
        changed
    }

    #[test]
    fn arguments_change_places() {
        assert_eq!(arguments("p(a, b,c)", "210"), "p(c, b,a)");
        assert_eq!(arguments("p( a , bb )", "10"), "p( bb , a )");
    }

    #[test]
    fn removed_arguments_take_a_separator_along() {
        assert_eq!(arguments("p(a, b,c)", "02"), "p(a,c)");
        assert_eq!(arguments("p(a, b,c)", "12"), "p(b,c)");
        assert_eq!(arguments("p(a, b,c)", "2"), "p(c)");
        assert_eq!(arguments("p(a, b,c)", "0"), "p(a)");
        assert_eq!(arguments("p( a, b )", ""), "p(  )");
        assert_eq!(arguments("p(a)", ""), "p()");
    }

    #[test]
    fn added_arguments_are_separated() {
        assert_eq!(arguments("p(a,b)", "0x1y"), "p(a,x,b,y)");
        assert_eq!(arguments("p(a, b)", "xy01"), "p(x, y, a, b)");
        assert_eq!(arguments("p(a,b)", "xy"), "p(x,y)");
        assert_eq!(arguments("p(a,b,c)", "x2y0"), "p(x,c,y,a)");
    }

    #[test]
    fn an_added_argument_can_be_removed_without_a_trace() {
        for (text, order, back) in [
            ("p( a , b)", "0x1", "02"),
            ("p(a,  b)", "x01", "12"),
            ("p(a ,b )", "01x", "01"),
            ("p(a,b,c)", "01xy2", "014"),
        ] {
            assert_eq!(arguments(&arguments(text, order), back), text);
        }
    }
}
