//! Thinning: fewer rows for the same motion, so that a recorded trace is small and its changes are readable.

use val3_plot::significant;

use crate::distance::{Tolerances, distance_to_piece};
use crate::row::{Trace, TraceRow};

/// Maximum deviation of the path between the kept rows.
const PATH: Tolerances = Tolerances { mm: 0.05, degrees: 0.05, time: 0.0 };

/// Maximum deviation, in mm or degrees, from the position at the same time with constant speed between the kept rows.
const MOMENT: f64 = 2.0;

impl Trace {
    /// Returns the same motion with fewer rows: the path deviates by less than 0.05 mm and 0.05 degrees, and the times
    /// of moves and rests are unchanged.
    #[must_use]
    pub fn thinned(&self) -> Self {
        let parts = self.rows.chunk_by(|row, next| row.number() == next.number() && row.phase == next.phase);
        let rows = parts.flat_map(|part| {
            let kept = significant(part.len(), |place, from, to| excess(part, place, from, to));
            part.iter().zip(kept).filter(|(_, kept)| *kept).map(|(row, _)| *row)
        });
        Self { rows: rows.collect(), ..self.clone() }
    }
}

/// Returns the distance of a row to the line between two other rows, as a multiple of the maximum.
fn excess(rows: &[TraceRow], place: usize, from: usize, to: usize) -> f64 {
    let [Some(row), Some(from), Some(to)] = [place, from, to].map(|place| rows.get(place)) else { return 0.0 };
    let distance = distance_to_piece(row, from, to, &PATH);
    let of_path = distance.pose_excess(&PATH).max(distance.joints / PATH.degrees);
    of_path.max(from_moment(row, from, to) / MOMENT)
}

/// Returns the maximum difference of the position and the joints from constant speed.
fn from_moment(row: &TraceRow, from: &TraceRow, to: &TraceRow) -> f64 {
    let share = (row.time - from.time) as f64 / (to.time - from.time) as f64;
    let even = |from: f64, to: f64| from + (to - from) * share;
    let place = from.position().lerp(&to.position(), share);
    let joints = row.joints.iter().zip(from.joints.iter().zip(to.joints));
    let joints = joints.map(|(joint, (from, to))| (joint - even(*from, to)).abs());
    joints.fold((row.position() - place).norm(), f64::max)
}

#[cfg(test)]
mod tests {
    use val3_motion::MotionPhase;

    use super::*;
    use crate::testing::{at, line, trace};

    #[test]
    fn ends_of_moves_and_rests_stay() {
        let phases =
            [MotionPhase::Nominal; 12].into_iter().chain([MotionPhase::Blend; 5]).chain([MotionPhase::Waiting; 2]);
        let rows = line(19).into_iter().zip(phases);
        let rows: Vec<TraceRow> = rows.map(|(row, phase)| TraceRow { phase, ..row }).collect();
        let kept: Vec<usize> = trace(&rows).thinned().rows.iter().map(|row| row.time as usize / 4_000_000).collect();
        // The move number changes with row 10.
        assert_eq!(kept, [0, 10, 11, 12, 16, 17, 18]);
    }

    #[test]
    fn corners_of_path_rotation_joints_and_speed_stay() {
        assert!(!keeps(&|_, _| {}));
        assert!(keeps(&|way, row| row.pose.translation.vector.z += 0.051 / 4.0 * way));
        assert!(!keeps(&|way, row| row.pose.translation.vector.z += 0.049 / 4.0 * way));
        assert!(keeps(&|way, row| *row = at(row, [0.0; 3], [0.0, 0.0, 0.051 / 4.0 * way])));
        assert!(!keeps(&|way, row| *row = at(row, [0.0; 3], [0.0, 0.0, 0.049 / 4.0 * way])));
        assert!(keeps(&|way, row| row.joints[4] += 0.051 / 4.0 * way));
        assert!(!keeps(&|way, row| row.joints[4] += 0.049 / 4.0 * way));
        // On the same path, at other times.
        for (late, stays) in [(2.1, true), (1.9, false)] {
            let lag = |way: f64| late / 4.0 * (4.0 - way);
            assert_eq!(
                keeps(&|way, row| (row.pose.translation.vector.x, row.joints) = (row.joints[0] - lag(way), [0.0; 6])),
                stays
            );
            assert_eq!(
                keeps(&|way, row| (row.pose, row.joints[0]) = (Default::default(), row.joints[0] - lag(way))),
                stays
            );
        }
    }

    /// Whether thinning keeps the fifth of nine rows. `change` edits each row by its distance from the fifth, in rows.
    fn keeps(change: &dyn Fn(f64, &mut TraceRow)) -> bool {
        let mut rows = line(9);
        rows.iter_mut().zip(0..).for_each(|(row, place)| change(f64::from(i32::abs(place - 4)), row));
        trace(&rows).thinned().rows.iter().any(|row| row.time == 16_000_000)
    }
}
