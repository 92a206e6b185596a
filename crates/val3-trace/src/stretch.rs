//! Stretches of a trace: consecutive rows of the same move.

use std::ops::Range;

use crate::row::TraceRow;

/// The rows of a move.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Stretch {
    /// Move number.
    pub(crate) number: i64,
    /// Row range in the trace.
    pub(crate) rows: Range<usize>,
}

/// Returns the stretches sorted by time.
pub(crate) fn stretches(rows: &[TraceRow]) -> Vec<Stretch> {
    let (mut stretches, mut start) = (Vec::new(), 0);
    for chunk in rows.chunk_by(|row, next| row.number() == next.number()) {
        let end = start + chunk.len();
        stretches.extend(chunk.first().map(|row| Stretch { number: row.number(), rows: start..end }));
        start = end;
    }
    stretches
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::line;

    #[test]
    fn the_end_of_a_move_belongs_to_it() {
        let ids = [1.1, 1.9, 2.0, 2.3, 4.0, 4.5];
        let rows: Vec<TraceRow> = line(6).into_iter().zip(ids).map(|(row, id)| TraceRow { id, ..row }).collect();
        let expected = [(1, 0..3), (2, 3..4), (3, 4..5), (4, 5..6)].map(|(number, rows)| Stretch { number, rows });
        assert_eq!(stretches(&rows), expected);
        assert_eq!(stretches(&[]), []);
    }
}
