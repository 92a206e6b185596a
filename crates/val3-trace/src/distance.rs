//! The distance of a place to a path, which does not depend on time.

use val3_geometry::{Rotation3, Vector3, rotation};
use val3_kinematics::Joints;

use crate::row::Row;

/// The difference of an axis, in degrees, from which on two joint positions with the same pose are different configurations.
pub(crate) const CONFIGURATION: f64 = 10.0;

/// The difference of an axis, in degrees, that weighs as much as a tolerance. It is large, so that joints say where on a path
/// a place is only if its pose does not.
const FAINT: f64 = 300.0;

/// The largest differences at which two motions are the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerances {
    /// Distance of the tool centre point, in mm.
    pub mm: f64,
    /// Rotation of the tool, in degrees.
    pub degrees: f64,
    /// Time of a move, in per cent of the recorded one.
    pub time: f64,
}

/// The distance of a place to the nearest place of a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance {
    /// Of the tool centre point, in mm.
    pub mm: f64,
    /// Rotation of the tool, in degrees.
    pub degrees: f64,
    /// Largest difference of an axis, in degrees.
    pub joints: f64,
    /// The nearest place of the path in world, in mm.
    pub nearest: Vector3<f64>,
}

impl Distance {
    /// The distance of the pose as a multiple of the tolerances.
    pub(crate) fn pose_excess(&self, tolerances: &Tolerances) -> f64 {
        (self.mm / tolerances.mm).max(self.degrees / tolerances.degrees)
    }

    /// The distance of the place as a multiple of the tolerances. Above 1 it is another place. Joints count only if the pose is
    /// the same, because those of another pose always differ.
    pub(crate) fn excess(&self, tolerances: &Tolerances) -> f64 {
        let pose = self.pose_excess(tolerances);
        if pose > 1.0 { pose } else { pose.max(self.joints / CONFIGURATION) }
    }

    /// Whether this place of the path counts rather than another one. Of those with the same pose within the tolerances, the
    /// one with the nearest joints counts, because a path may come to a pose more than once.
    fn is_nearer(&self, other: &Self, tolerances: &Tolerances) -> bool {
        let [own, others] = [self, other].map(|one| (one.pose_excess(tolerances).max(1.0), one.joints));
        own < others
    }
}

/// The distance of a place to the path through rows; none without rows.
pub(crate) fn distance(place: &Row, path: &[Row], tolerances: &Tolerances) -> Option<Distance> {
    let only = path.first().filter(|_| path.len() == 1).map(|row| Piece::between(row, row));
    let pieces = path.windows(2).filter_map(|pair| match pair {
        [from, to] => Some(Piece::between(from, to)),
        _ => None,
    });
    let distances = only.into_iter().chain(pieces).map(|piece| piece.distance(place, tolerances));
    distances.reduce(|best, next| if next.is_nearer(&best, tolerances) { next } else { best })
}

/// The distance of a place to the straight way between two rows.
pub(crate) fn distance_to_piece(place: &Row, from: &Row, to: &Row, tolerances: &Tolerances) -> Distance {
    Piece::between(from, to).distance(place, tolerances)
}

/// The straight way between two rows.
struct Piece<'a> {
    from: &'a Row,
    way: Way,
}

/// The way from a row: translation in mm, rotation as a vector in degrees in the axes of the row, joints.
struct Way {
    translation: Vector3<f64>,
    turn: Vector3<f64>,
    joints: Joints,
}

impl Way {
    fn between(from: &Row, to: &Row) -> Self {
        let turn = from.pose.rotation.inverse() * to.pose.rotation;
        let mut joints = to.joints;
        joints.iter_mut().zip(from.joints).for_each(|(joint, start)| *joint -= start);
        Self {
            translation: to.position() - from.position(),
            turn: rotation::to_vector(&turn).map(f64::to_degrees),
            joints,
        }
    }

    /// The scalar product in the space in which the tolerances are one long.
    fn dot(&self, other: &Self, tolerances: &Tolerances) -> f64 {
        let joints: f64 = self.joints.iter().zip(other.joints).map(|(own, others)| own * others).sum();
        self.translation.dot(&other.translation) / (tolerances.mm * tolerances.mm)
            + self.turn.dot(&other.turn) / (tolerances.degrees * tolerances.degrees)
            + joints / (FAINT * FAINT)
    }
}

impl<'a> Piece<'a> {
    fn between(from: &'a Row, to: &Row) -> Self {
        Self { from, way: Way::between(from, to) }
    }

    /// The distance of a place to the nearest place of the piece: tolerances of mm and degrees weigh the same.
    fn distance(&self, place: &Row, tolerances: &Tolerances) -> Distance {
        let offset = Way::between(self.from, place);
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
