//! List that keeps only its last items.

use std::collections::VecDeque;

use serde::Serialize;

/// Maximum number of kept items.
const KEPT: usize = 1000;

/// List with the number of all items, and the last items.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Listed<T> {
    /// Number of all items.
    pub(super) count: usize,
    /// The last items, in their order.
    pub(super) last: VecDeque<T>,
}

impl<T> Default for Listed<T> {
    fn default() -> Self {
        Self { count: 0, last: VecDeque::new() }
    }
}

impl<T> Listed<T> {
    /// Adds an item at the end.
    pub(super) fn push(&mut self, item: T) {
        self.count += 1;
        self.last.push_back(item);
        self.shorten(KEPT);
    }

    /// Removes the oldest items until at most this number is left.
    pub(super) fn shorten(&mut self, most: usize) {
        self.last.drain(..self.last.len().saturating_sub(most));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_items_are_kept_and_all_are_counted() {
        let mut listed = Listed::default();
        (0..KEPT + 5).for_each(|number| listed.push(number));
        assert_eq!((listed.count, listed.last.len(), listed.last.front()), (KEPT + 5, KEPT, Some(&5)));
        listed.shorten(2);
        assert_eq!(listed.last, [KEPT + 3, KEPT + 4]);
    }
}
