//! Three-way merge of sequences.

use similar::{Algorithm, DiffOp, capture_diff_slices};
use std::hash::Hash;
use std::ops::Range;
use val3_syntax::TextSlice;

/// A part of the merged sequence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Chunk {
    /// Range of ours: unchanged, or changed only in ours.
    Ours(Range<usize>),
    /// Range of theirs that replaces the second range, of ours.
    Theirs(Range<usize>, Range<usize>),
    /// Items that both sides have changed differently.
    Conflict {
        /// Range in the base.
        base: Range<usize>,
        /// Range in ours.
        ours: Range<usize>,
        /// Range in theirs.
        theirs: Range<usize>,
    },
}

/// Merges the changes on both sides since `base`.
pub(crate) fn merge<T: Ord + Hash + Eq>(base: &[T], ours: &[T], theirs: &[T]) -> Vec<Chunk> {
    let [in_ours, in_theirs] = [matches(base, ours), matches(base, theirs)];
    let mut chunks = Vec::new();
    let [mut b, mut o, mut t] = [0, 0, 0];
    loop {
        // The next item of the base that both sides have kept.
        let stable = (b..base.len()).find_map(|at| {
            let (Some(Some(ours)), Some(Some(theirs))) = (in_ours.get(at), in_theirs.get(at)) else { return None };
            Some((at, *ours, *theirs))
        });
        let (next, ours_next, theirs_next) = stable.unwrap_or((base.len(), ours.len(), theirs.len()));
        unstable([base, ours, theirs], [b..next, o..ours_next, t..theirs_next], &mut chunks);
        if stable.is_none() {
            return chunks;
        }
        push(&mut chunks, Chunk::Ours(ours_next..ours_next + 1));
        [b, o, t] = [next + 1, ours_next + 1, theirs_next + 1];
    }
}

/// Returns for each base item the index of the same item in the other sequence.
fn matches<T: Ord + Hash + Eq>(base: &[T], other: &[T]) -> Vec<Option<usize>> {
    let mut found = vec![None; base.len()];
    for op in capture_diff_slices(Algorithm::Patience, base, other) {
        if let DiffOp::Equal { old_index, new_index, len } = op {
            found.iter_mut().skip(old_index).take(len).zip(new_index..).for_each(|(found, at)| *found = Some(at));
        }
    }
    found
}

/// Merges a part between items that both sides have kept.
fn unstable<T: Ord + Hash + Eq>(
    [base, ours, theirs]: [&[T]; 3],
    [b, o, t]: [Range<usize>; 3],
    chunks: &mut Vec<Chunk>,
) {
    let (base_part, our_part, their_part) = (base.get(b.clone()), ours.get(o.clone()), theirs.get(t.clone()));
    if [base_part, our_part, their_part].into_iter().flatten().all(<[T]>::is_empty) {
        return;
    }
    if their_part == base_part || their_part == our_part {
        return push(chunks, Chunk::Ours(o));
    }
    if our_part == base_part {
        return push(chunks, Chunk::Theirs(t, o));
    }
    // Equal lines at the start and at the end of both sides are no conflict.
    let is_pair = |(first, second): &(usize, usize)| ours.get(*first) == theirs.get(*second);
    let start = o.clone().zip(t.clone()).take_while(is_pair).count();
    let limit = o.len().min(t.len()) - start;
    let end = o.clone().rev().zip(t.clone().rev()).take(limit).take_while(is_pair).count();
    let (our_middle, their_middle) = (o.start + start..o.end - end, t.start + start..t.end - end);
    push(chunks, Chunk::Ours(o.start..our_middle.start));
    if b.is_empty() {
        added_by_both([ours, theirs], [our_middle, their_middle], b.start, chunks);
    } else {
        chunks.push(Chunk::Conflict { base: b, ours: our_middle, theirs: their_middle });
    }
    push(chunks, Chunk::Ours(o.end - end..o.end));
}

/// Merges items that both sides have added. Equal items are no conflict.
fn added_by_both<T: Ord + Hash + Eq>(
    [ours, theirs]: [&[T]; 2],
    [o, t]: [Range<usize>; 2],
    base: usize,
    chunks: &mut Vec<Chunk>,
) {
    let [first, second] = [ours.part(o.clone()), theirs.part(t.clone())];
    for op in capture_diff_slices(Algorithm::Patience, first, second) {
        let shifted = |range: Range<usize>, by: usize| range.start + by..range.end + by;
        let (in_ours, in_theirs) = (shifted(op.old_range(), o.start), shifted(op.new_range(), t.start));
        match op {
            DiffOp::Equal { .. } => push(chunks, Chunk::Ours(in_ours)),
            _ => chunks.push(Chunk::Conflict { base: base..base, ours: in_ours, theirs: in_theirs }),
        }
    }
}

/// Appends a chunk, and joins consecutive ranges of ours.
fn push(chunks: &mut Vec<Chunk>, chunk: Chunk) {
    match (chunks.last_mut(), chunk) {
        (_, Chunk::Ours(range)) if range.is_empty() => {}
        (Some(Chunk::Ours(last)), Chunk::Ours(range)) if last.end == range.start => last.end = range.end,
        (_, chunk) => chunks.push(chunk),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn merged(base: &str, ours: &str, theirs: &str) -> String {
        let [base, ours, theirs] = [base, ours, theirs].map(|text| text.chars().collect::<Vec<_>>());
        let text = |items: &[char], range: &Range<usize>| items[range.clone()].iter().collect::<String>();
        let shown = merge(&base, &ours, &theirs).into_iter().map(|chunk| match chunk {
            Chunk::Ours(range) => text(&ours, &range),
            Chunk::Theirs(range, _) => text(&theirs, &range),
            Chunk::Conflict { base: b, ours: o, theirs: t } => {
                format!("<{}|{}={}>", text(&ours, &o), text(&base, &b), text(&theirs, &t))
            }
        });
        shown.collect()
    }

    #[test]
    fn changes_of_both_sides_are_joined() {
        assert_eq!(merged("abcdef", "aBcdef", "abcdEf"), "aBcdEf");
        assert_eq!(merged("abc", "ab", "xabc"), "xab");
        assert_eq!(merged("abc", "aXc", "aYc"), "a<X|b=Y>c");
        assert_eq!(merged("ac", "apXc", "apYc"), "ap<X|=Y>c");
        assert_eq!(merged("abc", "ac", "aYc"), "a<|b=Y>c");
        assert_eq!(merged("", "ab", "ab"), "ab");
        assert_eq!(merged("", "aXbcYd", "aZbcd"), "a<X|=Z>bc<Y|=>d");
    }

    proptest! {
        #[test]
        fn one_side_alone_is_the_result(base in "[a-d]{0,12}", side in "[a-d]{0,12}") {
            prop_assert_eq!(merged(&base, &base, &side), side.clone());
            prop_assert_eq!(merged(&base, &side, &base), side.clone());
            prop_assert_eq!(merged(&base, &side, &side), side);
        }
    }
}
