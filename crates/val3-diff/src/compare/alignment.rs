//! Alignment of sequences: corresponding, removed and inserted elements.

use std::ops::Range;

use rustc_hash::FxHashMap;

/// A step of the alignment, by element index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum AlignmentStep {
    /// The element is in both sequences, with the same or changed content.
    Pair {
        /// Index in the old sequence.
        old: usize,
        /// Index in the new sequence.
        new: usize,
    },
    /// The element is only in the old sequence.
    Removed(usize),
    /// The element is only in the new sequence.
    Inserted(usize),
}

/// Aligns two sequences in O(n log n). Elements that occur once in each sequence are anchors, in their longest common
/// order. Between two anchors, equal elements at both ends are paired first, then the rest in order. An alignment with
/// the fewest edits would need quadratic time for sequences without common elements.
pub(super) fn align(old: &[u32], new: &[u32]) -> Vec<AlignmentStep> {
    let mut alignment = Alignment { old, new, steps: Vec::with_capacity(old.len().max(new.len())) };
    let (mut old_start, mut new_start) = (0, 0);
    for (old_end, new_end) in increasing(&unique(old, new)) {
        alignment.add_between(old_start..old_end, new_start..new_end);
        alignment.steps.push(AlignmentStep::Pair { old: old_end, new: new_end });
        (old_start, new_start) = (old_end + 1, new_end + 1);
    }
    alignment.add_between(old_start..old.len(), new_start..new.len());
    alignment.steps
}

/// Two sequences, and the steps found so far.
struct Alignment<'s> {
    old: &'s [u32],
    new: &'s [u32],
    steps: Vec<AlignmentStep>,
}

/// Returns the elements that occur once in each sequence, in old order.
fn unique(old: &[u32], new: &[u32]) -> Vec<(usize, usize)> {
    let (old_indexes, new_indexes) = (unique_indexes(old), unique_indexes(new));
    let in_both = old.iter().filter_map(|element| {
        let index = |indexes: &FxHashMap<u32, Option<usize>>| indexes.get(element).copied().flatten();
        index(&old_indexes).zip(index(&new_indexes))
    });
    in_both.collect()
}

/// Returns the index of each element; `None` for an element that occurs several times.
fn unique_indexes(sequence: &[u32]) -> FxHashMap<u32, Option<usize>> {
    let mut indexes = FxHashMap::default();
    for (index, element) in sequence.iter().enumerate() {
        indexes.entry(*element).and_modify(|index| *index = None).or_insert(Some(index));
    }
    indexes
}

/// Returns the longest subsequence of the pairs with increasing new indexes.
fn increasing(pairs: &[(usize, usize)]) -> Vec<(usize, usize)> {
    // `ends`: for each length, the pair that ends a subsequence with the smallest new index. `predecessors`: the pair
    // before each pair.
    let mut ends: Vec<usize> = Vec::new();
    let mut predecessors: Vec<Option<usize>> = Vec::with_capacity(pairs.len());
    for (index, (_, new)) in pairs.iter().enumerate() {
        let length = ends.partition_point(|end| pairs.get(*end).is_some_and(|(_, other)| other < new));
        predecessors.push(length.checked_sub(1).and_then(|last| ends.get(last).copied()));
        match ends.get_mut(length) {
            Some(end) => *end = index,
            None => ends.push(index),
        }
    }
    let mut longest = Vec::with_capacity(ends.len());
    let mut next = ends.last().copied();
    while let Some(index) = next {
        longest.extend(pairs.get(index));
        next = predecessors.get(index).copied().flatten();
    }
    longest.reverse();
    longest
}

impl Alignment<'_> {
    /// Adds the steps for the elements between two anchors.
    fn add_between(&mut self, old: Range<usize>, new: Range<usize>) {
        let equal = self.equal_pairs(old.clone().zip(new.clone()));
        self.add_pairs(old.start, new.start, equal);
        let (old, new) = (old.start + equal..old.end, new.start + equal..new.end);
        let equal = self.equal_pairs(old.clone().rev().zip(new.clone().rev()));
        let (old_end, new_end) = (old.end - equal, new.end - equal);
        let (old_rest, new_rest) = (old_end - old.start, new_end - new.start);
        let changed = old_rest.min(new_rest);
        self.add_pairs(old.start, new.start, changed);
        self.steps.extend((old.start + changed..old_end).map(AlignmentStep::Removed));
        self.steps.extend((new.start + changed..new_end).map(AlignmentStep::Inserted));
        self.add_pairs(old_end, new_end, equal);
    }

    /// Returns the number of equal elements at the start of a sequence of index pairs.
    fn equal_pairs(&self, indexes: impl Iterator<Item = (usize, usize)>) -> usize {
        indexes.take_while(|(old, new)| self.old.get(*old) == self.new.get(*new)).count()
    }

    fn add_pairs(&mut self, old: usize, new: usize, count: usize) {
        self.steps.extend((0..count).map(|offset| AlignmentStep::Pair { old: old + offset, new: new + offset }));
    }
}

#[cfg(test)]
mod tests {
    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::*;

    fn shown(old: &str, new: &str) -> String {
        let ids = |text: &str| text.chars().map(u32::from).collect::<Vec<_>>();
        let steps = align(&ids(old), &ids(new)).into_iter().map(|step| match step {
            AlignmentStep::Pair { old, new } => format!("{old}{new}"),
            AlignmentStep::Removed(old) => format!("-{old}"),
            AlignmentStep::Inserted(new) => format!("+{new}"),
        });
        steps.collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn removed_and_inserted_elements_are_found() {
        assert_eq!(shown("abcd", "bcd"), "-0 10 21 32");
        assert_eq!(shown("abcd", "abxcd"), "00 11 +2 23 34");
        assert_eq!(shown("aab", "ab"), "00 -1 21");
        assert_eq!(shown("abc", "axc"), "00 11 22");
        assert_eq!(shown("ab", "ba"), "-0 10 +1");
        assert_eq!(shown("", "a"), "+0");
    }

    proptest! {
        #[test]
        fn every_element_has_one_step_in_order(old in vec(0..6_u32, 0..12), new in vec(0..6_u32, 0..12)) {
            let steps = align(&old, &new);
            let of_old = |step: &AlignmentStep| match step { AlignmentStep::Pair { old, .. } | AlignmentStep::Removed(old) => Some(*old), AlignmentStep::Inserted(_) => None };
            let of_new = |step: &AlignmentStep| match step { AlignmentStep::Pair { new, .. } | AlignmentStep::Inserted(new) => Some(*new), AlignmentStep::Removed(_) => None };
            prop_assert_eq!(steps.iter().filter_map(of_old).collect::<Vec<_>>(), (0..old.len()).collect::<Vec<_>>());
            prop_assert_eq!(steps.iter().filter_map(of_new).collect::<Vec<_>>(), (0..new.len()).collect::<Vec<_>>());
        }

        #[test]
        fn removed_elements_of_distinct_ones_are_the_only_steps_without_a_pair(kept in vec(prop::bool::ANY, 1..20)) {
            let old: Vec<u32> = (0..).zip(&kept).map(|(id, _)| id).collect();
            let new: Vec<u32> = (0..).zip(&kept).filter(|(_, kept)| **kept).map(|(id, _)| id).collect();
            let removed = align(&old, &new).iter().filter(|step| matches!(step, AlignmentStep::Removed(_))).count();
            prop_assert_eq!(removed, old.len() - new.len());
        }
    }
}
