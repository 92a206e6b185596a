//! Lines that a task may execute, and the result of a turn (5.4).

use crate::TurnEnd;

/// Result of a turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TurnReport {
    /// Reason why the turn has ended.
    pub end: TurnEnd,
    /// Number of executed lines.
    pub lines: u32,
    /// Number of remaining lines after [`Busy`](TurnEnd::Busy) or [`Suspended`](TurnEnd::Suspended); otherwise 0.
    pub left: u32,
    /// Whether the task has read the clock.
    pub reads_clock: bool,
    /// Whether a [watched value](crate::DataWatch) has changed.
    pub has_changed_data: bool,
}

/// Lines that a task may execute before it returns to the scheduler.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Grant {
    /// Lines in the current turn.
    pub first: u32,
    /// Lines in each directly following turn while no other task can run; 0 if another task can.
    pub per_turn: u32,
    /// Total number of lines.
    pub limit: u32,
}

impl Grant {
    /// Returns a grant for a single turn.
    #[must_use]
    pub const fn once(lines: u32) -> Self {
        Self { first: lines, per_turn: 0, limit: lines }
    }

    /// Returns the largest number of lines if no other task can run.
    pub(crate) fn budget(self) -> u32 {
        if self.per_turn == 0 { self.limit.min(self.first) } else { self.limit }
    }

    /// Returns the number of remaining lines in the turn that contains the last of `lines` lines.
    pub(crate) fn left(self, lines: u32) -> u32 {
        match lines.checked_sub(self.first) {
            Some(more) if self.per_turn > 0 => more.next_multiple_of(self.per_turn) - more,
            _ => self.first.saturating_sub(lines),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Grant;

    #[test]
    fn turns_that_follow_one_another_end_where_single_ones_do() {
        let alone = Grant { first: 3, per_turn: 10, limit: 2000 };
        assert_eq!(alone.budget(), 2000);
        assert_eq!([0, 1, 3, 4, 13, 14, 23].map(|lines| alone.left(lines)), [3, 2, 0, 9, 0, 9, 0]);
        let among_others = Grant { per_turn: 0, ..alone };
        assert_eq!(among_others.budget(), 3);
        assert_eq!([0, 1, 3].map(|lines| among_others.left(lines)), [3, 2, 0]);
        assert_eq!(Grant { limit: 2, ..among_others }.budget(), 2);
    }
}
