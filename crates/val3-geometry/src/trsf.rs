//! Type `trsf` (manual 9.3).

use std::ops::Mul;

use nalgebra::{IsometryMatrix3, Rotation3, Translation3, Vector3};

use crate::angles;

/// A translation, and a rotation about x, then about the new y, then about the new z (manual 9.3.1, 9.3.2).
///
/// Fields contain the written values: angles of any size, with any number of turns. Computed values have angles in
/// ]-180, 180], of which at least two are in [-90, 90] (unless `rx` is 180 and `ry` is 0); `rx` is 0 if `ry` is ±90; no
/// value is -0. Equality compares the fields (manual 9.3.3), so two forms of the same rotation differ.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Trsf {
    /// Along x, in mm.
    pub x: f64,
    /// Along y, in mm.
    pub y: f64,
    /// Along z, in mm.
    pub z: f64,
    /// About x, in degrees.
    pub rx: f64,
    /// About the y axis after `rx`, in degrees.
    pub ry: f64,
    /// About the z axis after `rx` and `ry`, in degrees.
    pub rz: f64,
}

impl Trsf {
    /// Identity, which is also the initial value of variables.
    pub const IDENTITY: Self = Self::new([0.0; 3], [0.0; 3]);

    /// Creates a transformation from its fields in the manual's order: lengths in mm, angles in degrees.
    #[must_use]
    pub const fn new([x, y, z]: [f64; 3], [rx, ry, rz]: [f64; 3]) -> Self {
        Self { x, y, z, rx, ry, rz }
    }

    /// Creates a transformation from a translation in mm and a rotation, with the angles that the controller computes.
    #[must_use]
    pub fn from_parts(translation: Vector3<f64>, rotation: &Rotation3<f64>) -> Self {
        Self::new(translation.add_scalar(0.0).into(), angles::from_rotation(rotation))
    }

    /// Converts the lengths to another unit by multiplying them with `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self { x: self.x * factor, y: self.y * factor, z: self.z * factor, ..*self }
    }

    /// Returns the translation, in mm.
    #[must_use]
    pub fn translation(&self) -> Vector3<f64> {
        Vector3::new(self.x, self.y, self.z)
    }

    /// Returns the angles `rx`, `ry`, `rz`, in degrees.
    #[must_use]
    pub const fn angles(&self) -> [f64; 3] {
        [self.rx, self.ry, self.rz]
    }

    /// Implements the instruction `distance` for two transformations (manual 9.3.4), in mm. Both are relative to the
    /// same frame.
    #[must_use]
    pub fn distance(&self, other: &Self) -> f64 {
        (other.translation() - self.translation()).norm()
    }

    /// Converts to matrices for computation. Quarter turns are exact.
    #[must_use]
    pub fn isometry(&self) -> IsometryMatrix3<f64> {
        let rotation = angles::to_rotation(self.angles());
        IsometryMatrix3::from_parts(Translation3::from(self.translation()), rotation)
    }

    /// Implements the operator `!` (manual 9.3.3): returns the inverse transformation.
    #[must_use]
    pub fn inverse(&self) -> Self {
        self.isometry().inverse().into()
    }
}

/// Operator `*` (manual 9.3.3): `right` is relative to `self`.
///
/// The instruction `appro` is this product, with the point on the left (manual 9.6.3).
impl Mul for Trsf {
    type Output = Self;

    fn mul(self, right: Self) -> Self {
        (self.isometry() * right.isometry()).into()
    }
}

impl From<IsometryMatrix3<f64>> for Trsf {
    fn from(isometry: IsometryMatrix3<f64>) -> Self {
        Self::from_parts(isometry.translation.vector, &isometry.rotation)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::{any_trsf, assert_near, near};

    /// Figure in manual 9.3.2: each angle rotates about an axis that the previous angles have rotated.
    #[test]
    fn angles_turn_one_after_the_other_about_the_new_axes() {
        let whole = Trsf::new([250.0, 350.0, 450.0], [20.0, 10.0, 30.0]);
        let place = Trsf::new([250.0, 350.0, 450.0], [0.0; 3]);
        let about = |angles| Trsf::new([0.0; 3], angles);
        assert_eq!(place * about([20.0, 0.0, 0.0]) * about([0.0, 10.0, 0.0]) * about([0.0, 0.0, 30.0]), whole);
        assert_eq!(Trsf::default() * whole, whole);
    }

    #[test]
    fn a_product_moves_in_the_frame_of_its_left_side() {
        let turned = Trsf::new([10.0, 0.0, 0.0], [0.0, 0.0, 90.0]);
        let step = Trsf::new([5.0, 0.0, 0.0], [0.0; 3]);
        assert_eq!(turned * step, Trsf::new([10.0, 5.0, 0.0], [0.0, 0.0, 90.0]));
        assert_eq!(step * turned, Trsf::new([15.0, 0.0, 0.0], [0.0, 0.0, 90.0]));
    }

    /// Example of `appro` (manual 9.6.3): 100 mm back along z of the destination.
    #[test]
    fn an_approach_goes_along_the_axes_of_the_destination() {
        let destination = Trsf::new([400.0, 0.0, 300.0], [180.0, 0.0, 0.0]);
        let approach = Trsf::new([0.0, 0.0, -100.0], [0.0; 3]);
        assert_eq!(destination * approach, Trsf::new([400.0, 0.0, 400.0], [180.0, 0.0, 0.0]));
    }

    #[test]
    fn an_inverse_of_quarter_turns_is_exact() {
        let trsf = Trsf::new([10.0, 20.0, 30.0], [0.0, 0.0, 90.0]);
        assert_eq!(trsf.inverse(), Trsf::new([-20.0, 10.0, -30.0], [0.0, 0.0, -90.0]));
        assert_eq!(format!("{:?}", Trsf::IDENTITY.inverse()), format!("{:?}", Trsf::IDENTITY));
    }

    #[test]
    fn equality_compares_fields() {
        assert_ne!(Trsf::new([0.0; 3], [0.0, 0.0, 180.0]), Trsf::new([0.0; 3], [0.0, 0.0, -180.0]));
        assert_ne!(Trsf::new([1.0, 0.0, 0.0], [0.0; 3]), Trsf::new([1.0_f64.next_up(), 0.0, 0.0], [0.0; 3]));
        assert_eq!(Trsf::new([-0.0; 3], [0.0; 3]), Trsf::IDENTITY);
    }

    #[test]
    fn a_distance_does_not_depend_on_orientations() {
        let (a, b) = (Trsf::new([1.0, 2.0, 3.0], [0.0; 3]), Trsf::new([4.0, 6.0, 15.0], [10.0, 20.0, 30.0]));
        assert_eq!(a.distance(&b), 13.0);
    }

    proptest! {
        #[test]
        fn products_are_associative(a in any_trsf(), b in any_trsf(), c in any_trsf()) {
            assert_near(&((a * b) * c), &(a * (b * c)))?;
        }

        #[test]
        fn an_inverse_undoes_on_either_side(trsf in any_trsf()) {
            assert_near(&(trsf * trsf.inverse()), &Trsf::IDENTITY)?;
            assert_near(&(trsf.inverse() * trsf), &Trsf::IDENTITY)?;
            assert_near(&trsf.inverse().inverse(), &trsf)?;
        }

        #[test]
        fn a_distance_is_the_same_from_either_end(a in any_trsf(), b in any_trsf(), c in any_trsf()) {
            prop_assert_eq!(a.distance(&b), b.distance(&a));
            prop_assert_eq!(a.distance(&a), 0.0);
            prop_assert!(a.distance(&c) <= a.distance(&b) + b.distance(&c) + 1e-9);
            prop_assert!(((c * a).distance(&(c * b)) - a.distance(&b)).abs() < 1e-9);
        }

        #[test]
        fn the_identity_changes_nothing(trsf in any_trsf()) {
            prop_assert!(near(&(trsf * Trsf::IDENTITY), &trsf));
            prop_assert_eq!(trsf * Trsf::IDENTITY, Trsf::IDENTITY * trsf);
            prop_assert_eq!((trsf * Trsf::IDENTITY).translation(), trsf.translation());
        }
    }
}
