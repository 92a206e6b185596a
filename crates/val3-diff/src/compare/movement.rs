//! Movements of positions.

use smol_str::SmolStr;
use val3_geometry::{Rotation3, Trsf, Vector3, chain, rotation};

use super::placement::Places;
use crate::model::{Displacement, Movement, Shift};
use crate::read::value::{AxisKind, FileValue};

/// Movements below this limit in mm or degrees are rounding errors.
const NOISE: f64 = 1e-6;

/// Returns the movement from an old to a new value of the position at a new path; `None` if the value is no position or
/// has not moved.
pub(super) fn of(path: &SmolStr, old: &FileValue, new: &FileValue, places: &mut Places<'_>) -> Option<Movement> {
    let (old_trsf, new_trsf) = (places.old.transformation(old)?, places.new.transformation(new)?);
    let is_same_father = old.father() == new.father();
    let is_same_place = old_trsf == new_trsf && is_same_father;
    if is_same_place {
        return None;
    }
    let in_father = is_same_father.then(|| between(&[old_trsf], &[new_trsf]));
    let shift = is_same_father.then(|| shift(&old_trsf, &new_trsf));
    let in_world = places.origin(path).and_then(|origin| in_world(&origin, path, places));
    Some(Movement { in_father, shift, in_world })
}

/// Returns the maximum changes of linear and of rotary axes; `None` if the values are no joint positions.
pub(super) fn of_axes(old: &FileValue, new: &FileValue, places: &Places<'_>) -> Option<Displacement> {
    let (old, new) = (old.axes()?, new.axes()?);
    let axes = || old.iter().zip(&new).map(|((kind, old), (_, new))| (*kind, *old, *new));
    let linear = axes().filter(|(kind, ..)| *kind == AxisKind::Linear);
    let rotary = axes().filter(|(kind, ..)| *kind == AxisKind::Rotary);
    let [old_unit, new_unit] = [places.old.unit(), places.new.unit()];
    Some(Displacement {
        distance_mm: greatest(linear.map(|(_, old, new)| old * old_unit - new * new_unit)),
        angle_deg: greatest(rotary.map(|(_, old, new)| old - new)),
    })
}

/// Returns the greatest absolute difference, rounded; 0 without differences.
fn greatest(differences: impl Iterator<Item = f64>) -> f64 {
    rounded(differences.map(f64::abs).fold(0.0, f64::max))
}

/// Returns the displacement in `world`, or on the flange for a tool, from the position at an old path to the position
/// at a new path.
pub(super) fn in_world(old: &str, new: &str, places: &mut Places<'_>) -> Option<Displacement> {
    let (old, new) = (places.old.chain(old)?, places.new.chain(new)?);
    Some(between(&old.links, &new.links))
}

/// Returns the translation and rotation along the axes of the father.
fn shift(old: &Trsf, new: &Trsf) -> Shift {
    let translation = new.translation() - old.translation();
    let turn = new.isometry().rotation * old.isometry().rotation.inverse();
    let rotation = rotation::to_vector(&turn).map(f64::to_degrees);
    let rounded = |vector: Vector3<f64>| [vector.x, vector.y, vector.z].map(|number| rounded(number) + 0.0);
    Shift { translation_mm: rounded(translation), rotation_deg: rounded(rotation) }
}

/// Returns the displacement between two chains. Common outer links add no rounding error.
pub(super) fn between(old: &[Trsf], new: &[Trsf]) -> Displacement {
    let turn = chain::position(new, old).isometry().rotation;
    let angle = rotation::angle_between(&Rotation3::identity(), &turn).to_degrees();
    Displacement { distance_mm: rounded(chain::distance(old, new)), angle_deg: rounded(angle) }
}

/// Rounds to a nanometre, which is finer than any arm, because both programs and people read these numbers.
fn rounded(number: f64) -> f64 {
    (number / NOISE).round() / (1.0 / NOISE).round()
}

impl Displacement {
    /// Whether there is no displacement.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.distance_mm < NOISE && self.angle_deg < NOISE
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_father_moves_a_point() {
        let point = Trsf::new([100.0, 0.0, 0.0], [0.0; 3]);
        let father = |rz| Trsf::new([0.0; 3], [0.0, 0.0, rz]);
        let found = between(&[point, father(0.0)], &[point, father(90.0)]);
        assert_eq!((found.distance_mm, found.angle_deg), (141.421356, 90.0));
        assert!(between(&[point, father(30.0)], &[point, father(30.0)]).is_zero());
    }

    #[test]
    fn angles_written_in_another_way_are_no_movement() {
        let turned = |rz| [Trsf::new([1.0, 2.0, 3.0], [0.0, 0.0, rz])];
        assert!(between(&turned(180.0), &turned(-180.0)).is_zero());
    }
}
