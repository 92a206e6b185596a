//! Times of moves.

use std::ops::Range;

use val3_lang::ports::Time;
use val3_vm::CYCLE;

use crate::row::TraceRow;

/// Time difference below which times are equal, even in per cent, because a move begins and ends within a cycle.
pub(crate) const UNCERTAINTY: Time = 2 * CYCLE;

/// Times for a part of a trace, in nanoseconds.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct TraceTimes {
    /// Time in motion.
    pub moving: Time,
    /// Time at rest before the arm moves again.
    pub resting: Time,
}

impl TraceTimes {
    /// Computes the times of some rows. A row ends the time since the previous row, at rest or in motion.
    pub(crate) fn of(rows: &[TraceRow], part: Range<usize>) -> Self {
        let mut times = Self::default();
        for place in part {
            let Some(row) = rows.get(place) else { break };
            let before = place.checked_sub(1).and_then(|before| rows.get(before));
            let passed = before.map_or(0, |before| row.time - before.time);
            match (before.is_some_and(TraceRow::is_moving), row.is_moving()) {
                (true, true) => times.moving += passed,
                (false, true) => {
                    times.moving += CYCLE;
                    times.resting += passed;
                }
                (true, false) => {}
                (false, false) => times.resting += passed,
            }
        }
        times
    }

    /// Returns the sum of both times.
    #[must_use]
    pub fn whole(&self) -> Time {
        self.moving + self.resting
    }
}

/// Returns the change of a time in per cent; infinite if the recorded time is 0.
#[must_use]
pub fn change(recorded: Time, present: Time) -> f64 {
    let [recorded, present] = [recorded, present].map(|time| time as f64);
    if recorded == present { 0.0 } else { (present - recorded) * 100.0 / recorded }
}

/// Whether the difference of times exceeds a tolerance in per cent of the recorded time.
pub(crate) fn differs(recorded: Time, present: Time, tolerance: f64) -> bool {
    recorded.abs_diff(present) > UNCERTAINTY && change(recorded, present).abs() > tolerance
}

#[cfg(test)]
mod tests {
    use val3_motion::MotionPhase;

    use super::*;
    use crate::testing::line;

    const MS: Time = 1_000_000;

    fn rows(states: &[(Time, MotionPhase)]) -> Vec<TraceRow> {
        let rows = line(states.len()).into_iter().zip(states);
        rows.map(|(row, (ms, phase))| TraceRow { time: ms * MS, phase: *phase, ..row }).collect()
    }

    fn times(moving: Time, resting: Time) -> TraceTimes {
        TraceTimes { moving: moving * MS, resting: resting * MS }
    }

    #[test]
    fn rows_that_were_left_out_count() {
        let (moves, rests) = (MotionPhase::Nominal, MotionPhase::Waiting);
        let states = [(100, moves), (120, MotionPhase::Blend), (124, rests), (200, moves), (204, moves), (208, rests)];
        let rows = rows(&states);
        assert_eq!(TraceTimes::of(&rows, 0..6), times(4 + 20 + 4 + 4, 76));
        assert_eq!(TraceTimes::of(&rows, 0..3), times(24, 0));
        assert_eq!(TraceTimes::of(&rows, 3..6), times(8, 76));
        assert_eq!(TraceTimes::of(&rows, 4..9), times(4, 0));
        assert_eq!(TraceTimes::of(&rows, 0..6).whole(), 108 * MS);
    }

    #[test]
    fn every_cycle_may_have_a_row() {
        let (moves, rests) = (MotionPhase::Nominal, MotionPhase::Waiting);
        let rows = rows(&[(0, rests), (4, rests), (8, moves), (12, moves), (16, rests), (20, rests)]);
        assert_eq!(TraceTimes::of(&rows, 0..6), times(8, 12));
    }

    #[test]
    fn changes_are_in_per_cent_of_the_recorded_time() {
        assert_eq!([change(200, 210), change(200, 190), change(0, 0)], [5.0, -5.0, 0.0]);
        assert_eq!(change(0, 1), f64::INFINITY);
        let second = 1000 * MS;
        assert!(!differs(second, second + 50 * MS, 5.0) && differs(second, second + 50 * MS + 1, 5.0));
        assert!(!differs(second, second - 50 * MS, 5.0) && differs(second, second - 50 * MS - 1, 5.0));
        assert!(!differs(second, second, 0.0));
    }

    #[test]
    fn two_cycles_are_no_difference() {
        assert!(!differs(20 * MS, 28 * MS, 5.0) && differs(20 * MS, 28 * MS + 1, 5.0));
        assert!(!differs(20 * MS, 12 * MS, 5.0) && differs(20 * MS, 12 * MS - 1, 5.0));
    }
}
