//! Interpolation between poses (manual 9.3.4).

use std::error::Error;
use std::fmt;

use nalgebra::{IsometryMatrix3, Translation3, Vector3};

use crate::arc::{Arc, ArcError};
use crate::{Trsf, rotation};

/// Path of `movel`: the position on a line, the orientation about one axis by the smaller angle.
#[derive(Clone, Copy, Debug)]
pub struct LinePath {
    start: IsometryMatrix3<f64>,
    translation: Vector3<f64>,
    turn: Vector3<f64>,
}

impl LinePath {
    /// Creates the path from `start` to `end`.
    ///
    /// If the orientations are half a turn apart, both directions are equally short. The rotation axis is then chosen
    /// so that its largest component, in the axes of `start`, is positive.
    #[must_use]
    pub fn between(start: &IsometryMatrix3<f64>, end: &IsometryMatrix3<f64>) -> Self {
        Self {
            start: *start,
            translation: end.translation.vector - start.translation.vector,
            turn: rotation::to_vector(&(start.rotation.inverse() * end.rotation)),
        }
    }

    /// Returns the path length from start to end, in mm.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.translation.norm()
    }

    /// Returns the pose at a fraction of the path: 0 is the start, 1 the end. Values beyond them continue along the
    /// line.
    #[must_use]
    pub fn at(&self, fraction: f64) -> IsometryMatrix3<f64> {
        let place = self.start.translation.vector + self.translation * fraction;
        let rotation = self.start.rotation * rotation::from_vector(&(self.turn * fraction));
        IsometryMatrix3::from_parts(Translation3::from(place), rotation)
    }
}

/// Reason why no pose can be interpolated; run-time error 70 in VAL 3.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InterpolationError {
    /// The fraction is not in ]-1, 2[.
    Fraction,
    /// The three poses define no arc.
    Arc(ArcError),
}

impl fmt::Display for InterpolationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fraction => f.write_str("the position is not between -1 and 2"),
            Self::Arc(error) => error.fmt(f),
        }
    }
}

impl Error for InterpolationError {}

/// Implements the instruction `interpolateL` (manual 9.3.4): computes the pose at `fraction` of the path from `start`
/// to `end`.
///
/// At 0 and 1 the result is exactly `start` and `end`.
///
/// # Errors
/// The fraction is outside ]-1, 2[.
pub fn interpolate_l(start: &Trsf, end: &Trsf, fraction: f64) -> Result<Trsf, InterpolationError> {
    at_fraction(start, end, fraction, || LinePath::between(&start.isometry(), &end.isometry()).at(fraction))
}

/// Implements the instruction `interpolateC` (manual 9.3.4): computes the pose at `fraction` of the arc from `start`
/// through `intermediate` to `end`.
///
/// At 0 and 1 the result is exactly `start` and `end`. The manual states the range of the fraction only for
/// `interpolateL`; the same range applies here.
///
/// # Errors
/// The fraction is outside ]-1, 2[, or the poses define no arc, even if the fraction is 0 or 1.
pub fn interpolate_c(start: &Trsf, intermediate: &Trsf, end: &Trsf, fraction: f64) -> Result<Trsf, InterpolationError> {
    let arc = Arc::through(&start.isometry(), &intermediate.isometry(), &end.isometry());
    let arc = arc.map_err(InterpolationError::Arc)?;
    at_fraction(start, end, fraction, || arc.at(fraction))
}

/// Returns the exact ends for 0 and 1, and computed poses for other fractions.
fn at_fraction(
    start: &Trsf,
    end: &Trsf,
    fraction: f64,
    place: impl FnOnce() -> IsometryMatrix3<f64>,
) -> Result<Trsf, InterpolationError> {
    match fraction {
        0.0 => Ok(*start),
        1.0 => Ok(*end),
        _ if -1.0 < fraction && fraction < 2.0 => Ok(place().into()),
        _ => Err(InterpolationError::Fraction),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::{any_trsf, assert_near};

    const START: Trsf = Trsf::new([100.0, 0.0, 50.0], [0.0, 0.0, 30.0]);
    const END: Trsf = Trsf::new([300.0, -40.0, 50.0], [0.0, 0.0, 90.0]);

    #[test]
    fn the_ends_are_the_places_as_they_are_written() {
        let start = Trsf::new([0.1, 0.2, 0.3], [0.0, 0.0, 350.0]);
        assert_eq!(interpolate_l(&start, &END, 0.0), Ok(start));
        assert_eq!(interpolate_l(&END, &start, 1.0), Ok(start));
    }

    #[test]
    fn on_the_way_and_beyond() {
        let at = |fraction| interpolate_l(&START, &END, fraction).unwrap();
        assert_eq!(at(0.5), Trsf::new([200.0, -20.0, 50.0], [0.0, 0.0, 60.0]));
        assert_eq!(at(-0.5), Trsf::new([0.0, 20.0, 50.0], [0.0; 3]));
        assert_eq!(at(1.5), Trsf::new([400.0, -60.0, 50.0], [0.0, 0.0, 120.0]));
    }

    #[test]
    fn the_range_is_open_at_both_ends() {
        for outside in [-1.0, 2.0, -1e300, f64::NAN] {
            assert_eq!(interpolate_l(&START, &END, outside), Err(InterpolationError::Fraction));
        }
        assert!(interpolate_l(&START, &END, (-1.0_f64).next_up()).is_ok());
        assert!(interpolate_l(&START, &END, 2.0_f64.next_down()).is_ok());
    }

    #[test]
    fn the_orientation_takes_the_smaller_angle() {
        let at = |rz| Trsf::new([0.0; 3], [0.0, 0.0, rz]);
        assert_eq!(interpolate_l(&at(170.0), &at(-170.0), 0.25), Ok(at(175.0)));
        assert_eq!(interpolate_l(&at(0.0), &at(180.0), 0.5), Ok(at(90.0)));
    }

    proptest! {
        #[test]
        fn the_position_follows_the_manuals_equation(a in any_trsf(), b in any_trsf(), fraction in -0.99..1.99) {
            let place = interpolate_l(&a, &b, fraction).unwrap();
            let expected = a.translation() + (b.translation() - a.translation()) * fraction;
            prop_assert!((place.translation() - expected).amax() < 1e-9);
        }

        #[test]
        fn equal_steps_turn_by_equal_angles(a in any_trsf(), b in any_trsf()) {
            let line = LinePath::between(&a.isometry(), &b.isometry());
            let step = Trsf::from(line.at(0.0).inverse() * line.at(0.25));
            let next = Trsf::from(line.at(0.25).inverse() * line.at(0.5));
            let turn = Trsf { x: 0.0, y: 0.0, z: 0.0, ..step };
            let next_turn = Trsf { x: 0.0, y: 0.0, z: 0.0, ..next };
            assert_near(&turn, &next_turn)?;
            assert_near(&line.at(0.0).into(), &a)?;
            assert_near(&line.at(1.0).into(), &b)?;
        }
    }
}
