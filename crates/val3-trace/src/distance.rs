//! Distance between a point and a path, independent of time.

use val3_geometry::{Rotation3, Vector3, rotation};
use val3_kinematics::Joints;

use crate::row::TraceRow;

/// Axis difference in degrees from which two joint positions with the same pose have different configurations.
pub(crate) const CONFIGURATION: f64 = 10.0;

/// Axis difference in degrees that has the weight of a tolerance. It is large, so that joints select the point on a
/// path only if the pose is ambiguous.
const FAINT: f64 = 300.0;

/// Maximum differences at which two motions are equal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerances {
    /// Distance of the tool centre points in mm.
    pub mm: f64,
    /// Rotation of the tool in degrees.
    pub degrees: f64,
    /// Difference of a move's time in per cent of the recorded time.
    pub time: f64,
}

/// Distance between a point and the nearest point of a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance {
    /// Distance of the tool centre points in mm.
    pub mm: f64,
    /// Rotation of the tool in degrees.
    pub degrees: f64,
    /// Maximum difference of the axes in degrees.
    pub joints: f64,
    /// Nearest point of the path in world, in mm.
    pub nearest: Vector3<f64>,
}

impl Distance {
    /// Returns the distance of the pose as a multiple of the tolerances.
    pub(crate) fn pose_excess(&self, tolerances: &Tolerances) -> f64 {
        (self.mm / tolerances.mm).max(self.degrees / tolerances.degrees)
    }

    /// Returns the distance as a multiple of the tolerances; above 1, the point differs. Joints are compared only if
    /// the pose is equal, because the joints for different poses always differ.
    pub(crate) fn excess(&self, tolerances: &Tolerances) -> f64 {
        let pose = self.pose_excess(tolerances);
        if pose > 1.0 { pose } else { pose.max(self.joints / CONFIGURATION) }
    }

    /// Whether this point of the path is nearer than `other`. Of points with equal poses within the tolerances, the
    /// point with the nearest joints is nearer, because a path may reach a pose several times.
    fn is_nearer(&self, other: &Self, tolerances: &Tolerances) -> bool {
        let [own, others] = [self, other].map(|one| (one.pose_excess(tolerances).max(1.0), one.joints));
        own < others
    }
}

/// Returns the distance between a point and the path through rows; `None` without rows.
pub(crate) fn distance(place: &TraceRow, path: &[TraceRow], tolerances: &Tolerances) -> Option<Distance> {
    let only = path.first().filter(|_| path.len() == 1).map(|row| PathSection::between(row, row));
    let pieces = path.windows(2).filter_map(|pair| match pair {
        [from, to] => Some(PathSection::between(from, to)),
        _ => None,
    });
    let distances = only.into_iter().chain(pieces).map(|piece| piece.distance(place, tolerances));
    distances.reduce(|best, next| if next.is_nearer(&best, tolerances) { next } else { best })
}

/// Returns the distance between a point and the straight line between two rows.
pub(crate) fn distance_to_piece(place: &TraceRow, from: &TraceRow, to: &TraceRow, tolerances: &Tolerances) -> Distance {
    PathSection::between(from, to).distance(place, tolerances)
}

/// The straight line between two rows.
struct PathSection<'a> {
    from: &'a TraceRow,
    way: RowOffset,
}

/// Displacement from a row: translation in mm, rotation vector in degrees in the axes of the row, and joints.
struct RowOffset {
    translation: Vector3<f64>,
    turn: Vector3<f64>,
    joints: Joints,
}

impl RowOffset {
    fn between(from: &TraceRow, to: &TraceRow) -> Self {
        let turn = from.pose.rotation.inverse() * to.pose.rotation;
        let mut joints = to.joints;
        joints.iter_mut().zip(from.joints).for_each(|(joint, start)| *joint -= start);
        Self {
            translation: to.position() - from.position(),
            turn: rotation::to_vector(&turn).map(f64::to_degrees),
            joints,
        }
    }

    /// Returns the scalar product in the space in which the tolerances have length 1.
    fn dot(&self, other: &Self, tolerances: &Tolerances) -> f64 {
        let joints: f64 = self.joints.iter().zip(other.joints).map(|(own, others)| own * others).sum();
        self.translation.dot(&other.translation) / (tolerances.mm * tolerances.mm)
            + self.turn.dot(&other.turn) / (tolerances.degrees * tolerances.degrees)
            + joints / (FAINT * FAINT)
    }
}

impl<'a> PathSection<'a> {
    fn between(from: &'a TraceRow, to: &TraceRow) -> Self {
        Self { from, way: RowOffset::between(from, to) }
    }

    /// Returns the distance between a point and the nearest point of the line. Tolerances in mm and in degrees have
    /// equal weights.
    fn distance(&self, place: &TraceRow, tolerances: &Tolerances) -> Distance {
        let offset = RowOffset::between(self.from, place);
        let square = self.way.dot(&self.way, tolerances);
        let share = if square > 0.0 { (offset.dot(&self.way, tolerances) / square).clamp(0.0, 1.0) } else { 0.0 };
        let nearest = self.from.position() + self.way.translation * share;
        let rotation = self.rotation(share);
        let joints = offset.joints.iter().zip(self.way.joints).map(|(own, way)| (own - way * share).abs());
        Distance {
            mm: (place.position() - nearest).norm(),
            degrees: rotation::angle_between(&rotation, &place.pose.rotation).to_degrees(),
            joints: joints.fold(0.0, f64::max),
            nearest,
        }
    }

    fn rotation(&self, share: f64) -> Rotation3<f64> {
        self.from.pose.rotation * rotation::from_vector(&(self.way.turn * share).map(f64::to_radians))
    }
}

#[cfg(test)]
mod tests;
