//! Message `motion`: the recorded moves, and the remaining path of the tool centre point.

use val3_geometry::Vector3;
use val3_machine::controller::{BlendPoint, Controller, RecordedMove};
use val3_motion::{MoveStage, PieceAhead};

use crate::coordinates;
use crate::wire::{MotionMessage, QueueEntry, WayPiece};

/// Maximum number of path pieces in the message: nominal sections and blends.
const PIECES: usize = 60;

/// Maximum deviation of the drawn path, in mm.
const TOLERANCE: f64 = 0.2;

/// Units of path coordinates and poses per mm or degree. With more digits, they would make up half of a recording.
const PATH_UNITS: f64 = 100.0;
const POSE_UNITS: f64 = 10_000.0;

/// Properties that determine the message, without the progress on the current piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MotionKey {
    revision: u64,
    moves: usize,
    present: Option<(u64, MoveStage)>,
    is_away: bool,
}

impl MotionKey {
    pub(crate) fn of(controller: &Controller) -> Self {
        let arm = controller.arm();
        let moves = arm.motion().moves();
        Self {
            revision: arm.motion().revision(),
            moves: moves.len(),
            present: arm.motion().moves().next().map(|queued| (queued.serial, queued.stage)),
            is_away: arm.is_away(),
        }
    }
}

/// Creates the message at a time in seconds. `number` returns the number of the line that requests a move.
pub(crate) fn message(t: f64, controller: &Controller, mut number: impl FnMut(&RecordedMove) -> u16) -> MotionMessage {
    let queue = controller.motion_queue();
    MotionMessage {
        t,
        queue: queue.iter().map(|queued| recorded(queued, number(queued))).collect(),
        path: way_ahead(controller),
    }
}

fn recorded(queued: &RecordedMove, source: u16) -> QueueEntry {
    let pose = |corner: &BlendPoint| rounded(coordinates(&corner.pose), POSE_UNITS);
    let distance = |corner: &BlendPoint| corner.distance.0;
    QueueEntry {
        id: queued.id,
        instruction: queued.source.as_ref().map(|source| source.instruction.to_owned()),
        source,
        phase: queued.stage.word().to_owned(),
        target: rounded(coordinates(&queued.target), POSE_UNITS),
        leave: queued.leave.as_ref().map(pose),
        reach: queued.reach.as_ref().map(pose),
        leave_distance: queued.leave.as_ref().map(distance),
        reach_distance: queued.reach.as_ref().map(distance),
        blend: queued.blend.clone(),
        blend_cut_short: queued.blend.note(),
    }
}

/// Remaining path of the tool centre point to the last destination, in mm, by piece.
fn way_ahead(controller: &Controller) -> Vec<WayPiece> {
    let pieces = controller.arm().motion().way_ahead(PIECES);
    let pieces = pieces.iter().map(|PieceAhead { phase, points }| {
        let points = simplified(points, TOLERANCE);
        let points = points.iter().map(|point| rounded((*point).into(), PATH_UNITS)).collect();
        WayPiece { phase: phase.word().to_owned(), points }
    });
    pieces.collect()
}

/// Rounds numbers to whole units. A quotient has the shortest decimal text, unlike a product with the size of a unit.
fn rounded<const N: usize>(numbers: [f64; N], units: f64) -> [f64; N] {
    // Adding 0.0 removes the sign of a negative zero.
    numbers.map(|number| (number * units).round() / units + 0.0)
}

/// Simplifies a curve by removing points that are within the tolerance of the lines between the other points
/// (Douglas-Peucker).
fn simplified(points: &[Vector3<f64>], tolerance: f64) -> Vec<Vector3<f64>> {
    let [first, inner @ .., last] = points else { return points.to_vec() };
    let distances = inner.iter().map(|point| distance_to_chord(point, first, last));
    let widest = distances.enumerate().max_by(|(_, one), (_, other)| one.total_cmp(other));
    match widest {
        Some((index, distance)) if distance > tolerance => {
            let (before, after) = (points.get(..=index + 1), points.get(index + 1..));
            let mut found = simplified(before.unwrap_or_default(), tolerance);
            found.pop();
            found.extend(simplified(after.unwrap_or_default(), tolerance));
            found
        }
        _ => vec![*first, *last],
    }
}

fn distance_to_chord(point: &Vector3<f64>, first: &Vector3<f64>, last: &Vector3<f64>) -> f64 {
    let along = last - first;
    let share = ((point - first).dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    (point - first - along * share).norm()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounded_numbers_have_short_texts() {
        let texts = rounded([187.171_234, -57.158_9, 0.001, -0.001], PATH_UNITS).map(|number| number.to_string());
        assert_eq!(texts, ["187.17", "-57.16", "0", "0"]);
    }

    #[test]
    fn points_on_straight_lines_are_left_out() {
        let curve: Vec<Vector3<f64>> =
            (0..=20).map(|x| Vector3::new(f64::from(x), f64::from((x - 10).max(0)), 0.0)).collect();
        let kept = simplified(&curve, 0.1);
        assert_eq!(kept, [curve[0], curve[10], curve[20]]);
        let circle = [curve[0], curve[20], curve[0]];
        assert_eq!(simplified(&circle, 0.1), circle);
        assert_eq!(simplified(&curve[..1], 0.1), curve[..1]);
    }
}
