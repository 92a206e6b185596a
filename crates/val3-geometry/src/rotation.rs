//! Rotations as vectors: the direction is the axis, the length is the angle in radians.

use nalgebra::{Matrix3, Rotation3, Vector3};

/// Sine below which the two directions of a half turn differ only by noise.
const NOISE: f64 = 1e-12;

/// Returns the shortest rotation vector, with a length of at most π.
///
/// A half turn has two such vectors. The result is the vector whose largest component is positive.
#[must_use]
pub fn to_vector(rotation: &Rotation3<f64>) -> Vector3<f64> {
    let m = rotation.matrix();
    let twice_sine = Vector3::new(m.m32 - m.m23, m.m13 - m.m31, m.m21 - m.m12);
    let sin = twice_sine.norm() / 2.0;
    let cos = (m.trace() - 1.0) / 2.0;
    let angle = libm::atan2(sin, cos);
    if cos < 0.0 {
        let axis = axis_of_wide(m, cos);
        let backwards = sin > NOISE && axis.dot(&twice_sine) < 0.0;
        return if backwards { -axis * angle } else { axis * angle };
    }
    if sin == 0.0 { Vector3::zeros() } else { twice_sine * (angle / (2.0 * sin)) }
}

/// Returns the axis of a rotation by more than 90°, in the direction whose largest component is positive.
///
/// The symmetric part of the matrix is cos·I + (1-cos)·a·aᵀ; its columns are multiples of the axis.
fn axis_of_wide(m: &Matrix3<f64>, cos: f64) -> Vector3<f64> {
    let outer = (m + m.transpose()) / 2.0 - Matrix3::identity() * cos;
    let columns = [outer.column(0), outer.column(1), outer.column(2)];
    let [x, y, z] = [outer.m11, outer.m22, outer.m33];
    let [first, second, third] = columns;
    let largest = if x >= y && x >= z {
        first
    } else if y >= z {
        second
    } else {
        third
    };
    largest.normalize()
}

/// Returns the rotation about a vector by its length in radians.
#[must_use]
pub fn from_vector(vector: &Vector3<f64>) -> Rotation3<f64> {
    let angle = vector.norm();
    if angle == 0.0 {
        return Rotation3::identity();
    }
    let axis = vector / angle;
    let (sin, cos) = libm::sincos(angle);
    let matrix = Matrix3::identity() * cos + axis.cross_matrix() * sin + axis * axis.transpose() * (1.0 - cos);
    Rotation3::from_matrix_unchecked(matrix)
}

/// Returns the angle between two orientations in radians, at most π.
#[must_use]
pub fn angle_between(one: &Rotation3<f64>, other: &Rotation3<f64>) -> f64 {
    // Each axis moves by a chord. The squares of the three chords add up to 8·sin²(angle / 2).
    let chords = (one.matrix() - other.matrix()).norm();
    2.0 * libm::asin((chords / 8.0_f64.sqrt()).min(1.0))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_half_turn_has_a_direction_that_noise_does_not_change() {
        for noise in [-1e-13, 0.0, 1e-13] {
            let turn = from_vector(&Vector3::new(0.0, -(PI + noise), 0.0));
            assert!((to_vector(&turn) - Vector3::new(0.0, PI, 0.0)).amax() < 1e-12);
        }
    }

    #[test]
    fn no_turn_has_no_length() {
        assert_eq!(to_vector(&Rotation3::identity()), Vector3::zeros());
        assert_eq!(from_vector(&Vector3::zeros()), Rotation3::identity());
    }

    proptest! {
        #[test]
        fn the_angle_between_two_orientations_is_that_of_the_rotation_to_the_other(
            one in [-3.0..3.0_f64, -3.0..3.0_f64, -3.0..3.0_f64],
            turn in [-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64],
            scale in -9..1,
        ) {
            let (one, turn) = (from_vector(&Vector3::from(one)), Vector3::from(turn) * 10.0_f64.powi(scale));
            let angle = angle_between(&one, &(one * from_vector(&turn)));
            prop_assert!((angle - turn.norm()).abs() < 1e-14_f64.max(1e-6 * turn.norm()));
        }

        #[test]
        fn a_vector_comes_back(axis in [-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64], scale in -14..0) {
            let axis = Vector3::from(axis);
            prop_assume!(axis.norm() > 0.1);
            let tenth = 10.0_f64.powi(scale);
            for length in [tenth, 1.0, PI / 2.0, 3.0, PI - tenth.max(1e-11)] {
                let vector = axis.normalize() * length;
                prop_assert!((to_vector(&from_vector(&vector)) - vector).amax() < 1e-14_f64.max(length * 1e-13));
            }
        }
    }
}
