//! Corner distances computed only from the descriptors, for comparison with the planner.

use val3_geometry::Vector3;

use super::*;
use crate::{PathPiece, PieceEnd};

/// Number of chords for moves that are not lines.
const PARTS: i32 = 2000;

/// Path length of the tool centre point along a move in mm, from many short chords.
pub(super) fn length(from: &Joints, request: &Move) -> f64 {
    way(from, request, 0.0)
}

/// Path length of the tool centre point from the parameter `first` (0 to 1) to the move's end, in mm.
fn way(from: &Joints, request: &Move, first: f64) -> f64 {
    let parts = if matches!(request.path, MovePath::Line(_)) { 1 } else { PARTS };
    let place = |part: i32| place(from, request, first + (1.0 - first) * f64::from(part) / f64::from(parts));
    (0..parts).map(|part| (place(part + 1) - place(part)).norm()).sum()
}

/// Position of the tool centre point at the parameter `share` (0 to 1) along a move, in mm.
fn place(from: &Joints, request: &Move, share: f64) -> Vector3<f64> {
    match &request.path {
        MovePath::Joint(to) => {
            let between: Joints = std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * share);
            arm().flange(&between).translation.vector
        }
        MovePath::Line(to) => {
            let start = arm().flange(from).translation.vector;
            start + (to.pose.translation.vector - start) * share
        }
        MovePath::JointToPoint(_) | MovePath::Circle(..) => unreachable!("the tests have joint positions and lines"),
    }
}

/// Whether a position on a move is nearer than `reach` to its start and nearer than `leave` to its end, in mm.
fn overlap(from: &Joints, request: &Move, [reach, leave]: [f64; 2]) -> bool {
    let [start, end] = [0.0, 1.0].map(|share| place(from, request, share));
    let is_near_both = |place: Vector3<f64>| (place - start).norm() < reach && (place - end).norm() < leave;
    (0..=PARTS).any(|part| is_near_both(place(from, request, f64::from(part) / f64::from(PARTS))))
}

/// Leave and reach of a move.
#[derive(Clone, Copy, Default)]
pub(super) struct Distances {
    /// Effective distances, in mm.
    pub(super) effective: [f64; 2],
    /// Whether another corner of the same move reduces the requested distance.
    pub(super) is_reduced: [bool; 2],
    /// Whether the distances overlap with another corner on a bent path although the path is long enough. They may then
    /// be shorter.
    pub(super) is_limit: [bool; 2],
}

/// Effective distances in a program (manual 10.1.2.3): the blends before and after a move share its length.
pub(super) fn effective_distances(requests: &[Move], targets: &[Joints]) -> Vec<Distances> {
    let distances = |request: &Move| request.blend.distances().unwrap_or_default();
    let mut found = vec![Distances::default(); requests.len()];
    for (number, request) in requests.iter().enumerate() {
        let from = number.checked_sub(1).map_or(&START, |before| &targets[before]);
        let reach = number.checked_sub(1).map_or(0.0, |before| distances(&requests[before]).1);
        let (leave, _) = distances(request);
        let scale = (length(from, request) / (leave + reach)).min(1.0);
        let is_limit = scale == 1.0 && overlap(from, request, [reach, leave]);
        if let Some(before) = number.checked_sub(1) {
            (found[before].effective[1], found[before].is_reduced[1]) = (reach * scale, scale < 1.0);
            found[before].is_limit[1] = is_limit;
        }
        (found[number].effective[0], found[number].is_reduced[0]) = (leave * scale, scale < 1.0);
        found[number].is_limit[0] = is_limit;
    }
    found
}

/// Distance in mm from the end of a piece to its move's corner, and the tolerance.
///
/// Reduced distances are measured along the curve of a joint move, with chords.
pub(super) fn distance_from_corner(
    piece: &PathPiece,
    requests: &[Move],
    targets: &[Joints],
    is_reduced: bool,
) -> (f64, f64) {
    let corner = piece.serial as usize;
    let number = if piece.end == PieceEnd::Reach { corner + 1 } else { corner };
    let (request, to) = (&requests[number], targets[number]);
    if is_reduced && matches!(request.path, MovePath::Joint(_)) {
        let from = number.checked_sub(1).map_or(START, |before| targets[before]);
        let part = |joints: Joints| (Axes::from(joints) - Axes::from(from)).norm();
        let left = way(&from, request, part(piece.joints) / part(to));
        let way = if number == corner { left } else { length(&from, request) - left };
        return (way, 1e-2);
    }
    let corner = arm().flange(&targets[corner]).translation.vector;
    ((piece.pose.translation.vector - corner).norm(), 1e-4)
}
