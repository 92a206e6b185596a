//! Instruction `align` (manual 9.3.4).

use nalgebra::{Rotation3, Vector3};

use crate::{Trsf, rotation};

/// Largest difference between cosines to z for which two axes are equally near.
const EQUALLY_NEAR: f64 = 1e-9;

/// Sine below which the z axis is already aligned.
const ALIGNED: f64 = 1e-12;

/// Returns `position`, rotated by the smallest angle that aligns its z axis with the nearest axis of `reference`.
///
/// The candidates are the directions x, y, z, -x, -y, -z of `reference`; among equally near directions, the first is
/// chosen in the order x, y, z, each before its opposite. The angle is at most 54.74°. The coordinates `x`, `y`, `z` of
/// `position` are unchanged, and the coordinates of `reference` have no effect. An aligned position is returned
/// unchanged.
#[must_use]
pub fn align(position: &Trsf, reference: &Trsf) -> Trsf {
    let rotation = position.isometry().rotation;
    let z = rotation * Vector3::z();
    let target = nearest_axis(&z, &reference.isometry().rotation);
    let axis = z.cross(&target);
    let sin = axis.norm();
    if sin < ALIGNED {
        return *position;
    }
    let turn = rotation::from_vector(&(axis * (libm::atan2(sin, z.dot(&target)) / sin)));
    Trsf::from_parts(position.translation(), &(turn * rotation))
}

/// Returns the positive or negative axis of `reference` with the smallest angle to `direction`.
fn nearest_axis(direction: &Vector3<f64>, reference: &Rotation3<f64>) -> Vector3<f64> {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| reference * axis);
    let mut nearest = Vector3::zeros();
    for axis in axes.into_iter().flat_map(|axis| [axis, -axis]) {
        if axis.dot(direction) > nearest.dot(direction) + EQUALLY_NEAR {
            nearest = axis;
        }
    }
    nearest
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::any_trsf;

    fn turned(angles: [f64; 3]) -> Trsf {
        Trsf::new([1.0, 2.0, 3.0], angles)
    }

    #[test]
    fn z_goes_to_the_nearest_axis() {
        for (before, after) in [
            ([10.0, 0.0, 0.0], [0.0, 0.0, 0.0]),
            ([170.0, 0.0, 0.0], [180.0, 0.0, 0.0]),
            ([80.0, 0.0, 25.0], [90.0, 0.0, 25.0]),
            ([-80.0, 0.0, 25.0], [-90.0, 0.0, 25.0]),
            ([0.0, 80.0, 0.0], [0.0, 90.0, 0.0]),
            ([0.0, -80.0, 0.0], [0.0, -90.0, 0.0]),
        ] {
            assert_eq!(align(&turned(before), &Trsf::IDENTITY), turned(after));
        }
    }

    #[test]
    fn the_axes_are_those_of_the_reference_wherever_it_is() {
        let reference = Trsf::new([1000.0, 0.0, 0.0], [30.0, 0.0, 0.0]);
        assert_eq!(align(&turned([20.0, 0.0, 0.0]), &reference), turned([30.0, 0.0, 0.0]));
        assert_eq!(align(&turned([80.0, 0.0, 0.0]), &reference), turned([120.0, 0.0, 0.0]));
    }

    #[test]
    fn of_equally_near_axes_the_first_is_taken() {
        for noise in [-1e-12, 0.0, 1e-12] {
            assert_eq!(align(&turned([0.0, 45.0 + noise, 0.0]), &Trsf::IDENTITY), turned([0.0, 90.0, 0.0]));
            assert_eq!(align(&turned([-45.0 + noise, 0.0, 0.0]), &Trsf::IDENTITY), turned([-90.0, 0.0, 0.0]));
        }
    }

    #[test]
    fn aligned_positions_keep_their_angles() {
        assert_eq!(align(&turned([0.0, 0.0, 400.0]), &Trsf::IDENTITY), turned([0.0, 0.0, 400.0]));
    }

    proptest! {
        #[test]
        fn z_is_on_an_axis_after_the_smallest_turn(position in any_trsf(), reference in any_trsf()) {
            let aligned = align(&position, &reference);
            let [before, after, axes] = [&position, &aligned, &reference].map(|trsf| trsf.isometry().rotation);
            let z = axes.inverse() * (after * Vector3::z());
            prop_assert!((z.amax() - 1.0).abs() < 1e-12 && z.iter().filter(|part| part.abs() < 1e-12).count() == 2);
            let turn = rotation::to_vector(&(after * before.inverse())).norm().to_degrees();
            let cos = z.dot(&(axes.inverse() * (before * Vector3::z())));
            let smallest = crate::degrees::acos(cos.min(1.0)).unwrap();
            prop_assert!((turn - smallest).abs() < 1e-5 && turn < 54.736);
            prop_assert_eq!(aligned.translation(), position.translation());
            prop_assert_eq!(align(&aligned, &reference), aligned);
        }
    }
}
