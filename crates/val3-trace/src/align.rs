//! Alignment of traces: moves correspond in order, by number.

use std::ops::Range;

use similar::{Algorithm, DiffTag, capture_diff_slices};

use crate::stretch::Stretch;

/// A move in the recorded trace, in the present trace, or in both.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct MovePair {
    pub(crate) number: i64,
    /// Row range; an empty range at the move's place if the recorded trace does not contain it.
    pub(crate) recorded: Range<usize>,
    pub(crate) present: Range<usize>,
}

impl MovePair {
    fn new(number: i64, recorded: &Range<usize>, present: &Range<usize>) -> Self {
        Self { number, recorded: recorded.clone(), present: present.clone() }
    }
}

/// Aligns the moves in both traces.
pub(crate) fn aligned(recorded: &[Stretch], present: &[Stretch]) -> Vec<MovePair> {
    let [old, new] = [recorded, present].map(|stretches| stretches.iter().map(|one| one.number).collect::<Vec<_>>());
    let mut pairs = Vec::new();
    for operation in capture_diff_slices(Algorithm::Myers, &old, &new) {
        let (tag, old, new) = operation.as_tag_tuple();
        let recorded_ones = recorded.get(old.clone()).unwrap_or_default();
        let present_ones = present.get(new.clone()).unwrap_or_default();
        if tag == DiffTag::Equal {
            let both = recorded_ones.iter().zip(present_ones);
            pairs.extend(both.map(|(one, other)| MovePair::new(other.number, &one.rows, &other.rows)));
        } else {
            let (gap, gap_of_present) = (gap(recorded, old.end), gap(present, new.start));
            pairs.extend(recorded_ones.iter().map(|one| MovePair::new(one.number, &one.rows, &gap_of_present)));
            pairs.extend(present_ones.iter().map(|one| MovePair::new(one.number, &gap, &one.rows)));
        }
    }
    pairs
}

/// Returns the empty range before a stretch, or after the last one.
fn gap(stretches: &[Stretch], before: usize) -> Range<usize> {
    let last = before.checked_sub(1).and_then(|last| stretches.get(last));
    let place = last.map_or(0, |last| last.rows.end);
    place..place
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns stretches with two rows each.
    fn moves(numbers: &[i64]) -> Vec<Stretch> {
        let rows = |index: usize| 2 * index..2 * index + 2;
        numbers.iter().enumerate().map(|(index, number)| Stretch { number: *number, rows: rows(index) }).collect()
    }

    fn check(recorded: &[i64], present: &[i64], expected: &[(i64, Range<usize>, Range<usize>)]) {
        let pairs = aligned(&moves(recorded), &moves(present));
        let pairs: Vec<_> = pairs.into_iter().map(|pair| (pair.number, pair.recorded, pair.present)).collect();
        assert_eq!(pairs, expected);
    }

    #[test]
    fn moves_are_paired_by_their_numbers_in_order() {
        check(&[], &[], &[]);
        check(&[1, 2], &[1, 2], &[(1, 0..2, 0..2), (2, 2..4, 2..4)]);
        check(&[1, 2, 3], &[1, 3], &[(1, 0..2, 0..2), (2, 2..4, 2..2), (3, 4..6, 2..4)]);
        check(&[1, 3], &[1, 2, 3], &[(1, 0..2, 0..2), (2, 2..2, 2..4), (3, 2..4, 4..6)]);
        check(&[1], &[1, 2], &[(1, 0..2, 0..2), (2, 2..2, 2..4)]);
        check(&[0, 1], &[1], &[(0, 0..2, 0..0), (1, 2..4, 0..2)]);
        check(&[1], &[2], &[(1, 0..2, 0..0), (2, 2..2, 0..2)]);
        check(&[1, 2], &[], &[(1, 0..2, 0..0), (2, 2..4, 0..0)]);
    }

    /// `resetMotion` restarts the numbers at 0.
    #[test]
    fn numbers_that_begin_again_are_other_moves() {
        check(
            &[1, 2, -1, 0, 1],
            &[1, 2, 3, -1, 0, 1],
            &[
                (1, 0..2, 0..2),
                (2, 2..4, 2..4),
                (3, 4..4, 4..6),
                (-1, 4..6, 6..8),
                (0, 6..8, 8..10),
                (1, 8..10, 10..12),
            ],
        );
    }
}
