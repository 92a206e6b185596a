//! Arc through three poses (manual 9.3.4 `interpolateC`, 10.1.4.1).

use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::fmt;

use nalgebra::{IsometryMatrix3, Rotation3, Translation3, Vector3};

use crate::circle::Circle;
use crate::rotation;

/// Angle from which either direction of rotation could be meant: half a turn less a thousandth of a degree, in radians.
const HALF_TURN: f64 = PI - PI / 180.0 * 1e-3;

/// Angle below which two orientations are the same: a ten thousandth of a degree, in radians.
const SAME_ORIENTATION: f64 = PI / 180.0 * 1e-4;

/// Path of `movec`: the position on a circle, with the smallest possible rotation.
///
/// The rotation vector from the start is a quadratic function of the path length. Therefore the three orientations are
/// reached, a constant orientation remains constant, and an orientation that follows the circle continues to do so.
#[derive(Clone, Copy, Debug)]
pub struct Arc {
    circle: Circle,
    /// Angle of the entire arc, in radians.
    angle: f64,
    start: Rotation3<f64>,
    linear: Vector3<f64>,
    quadratic: Vector3<f64>,
}

/// Reason why three poses define no arc; run-time error 70 of `interpolateC`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArcError {
    /// Two positions are less than 0.001 mm apart. A full circle needs two arcs.
    TooClose,
    /// The three positions are collinear.
    Collinear,
    /// The direction of rotation is undetermined: the intermediate orientation is half a turn or more from the start or
    /// end orientation, or differs from it over half a circle or more.
    Orientation,
}

impl fmt::Display for ArcError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::TooClose => "two of the three positions are the same",
            Self::Collinear => "the three positions are on one line",
            Self::Orientation => "the intermediate position does not determine which way the orientation turns",
        })
    }
}

impl Error for ArcError {}

impl Arc {
    /// Creates the arc from `start` through `intermediate` to `end`.
    ///
    /// # Errors
    /// The positions define no circle, or the orientations no direction of rotation.
    pub fn through(
        start: &IsometryMatrix3<f64>,
        intermediate: &IsometryMatrix3<f64>,
        end: &IsometryMatrix3<f64>,
    ) -> Result<Self, ArcError> {
        let [from, through, to] = [start, intermediate, end].map(|place| place.translation.vector);
        let circle = Circle::through(&from, &through, &to)?;
        let (part, angle) = (circle.angle_to(&through), circle.angle_to(&to));
        let [to_middle, middle_to_end] = turns(start, intermediate, end, [part, angle - part])?;
        let whole = nearest(&(start.rotation.inverse() * end.rotation), &(to_middle + middle_to_end));
        let fraction = part / angle;
        let quadratic = (to_middle / fraction - whole) / (fraction - 1.0);
        Ok(Self { circle, angle, start: start.rotation, linear: whole - quadratic, quadratic })
    }

    /// Returns the path length from start to end, in mm.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.angle * self.circle.radius.norm()
    }

    /// Returns the pose at a fraction of the path: 0 is the start, 1 the end. Values beyond them continue along the
    /// circle.
    #[must_use]
    pub fn at(&self, fraction: f64) -> IsometryMatrix3<f64> {
        let turn = (self.linear + self.quadratic * fraction) * fraction;
        let place = self.circle.at(self.angle * fraction);
        IsometryMatrix3::from_parts(Translation3::from(place), self.start * rotation::from_vector(&turn))
    }
}

/// Returns the rotation vectors from the start to the intermediate pose and from there to the end, over arcs with these
/// angles.
fn turns(
    start: &IsometryMatrix3<f64>,
    intermediate: &IsometryMatrix3<f64>,
    end: &IsometryMatrix3<f64>,
    arcs: [f64; 2],
) -> Result<[Vector3<f64>; 2], ArcError> {
    let first = rotation::to_vector(&(start.rotation.inverse() * intermediate.rotation));
    let second = rotation::to_vector(&(intermediate.rotation.inverse() * end.rotation));
    let turns = [first, second];
    let mut angles = turns.iter().map(Vector3::norm).zip(arcs);
    if angles.any(|(turn, arc)| is_undetermined(turn, arc)) { Err(ArcError::Orientation) } else { Ok(turns) }
}

/// Whether the direction of a rotation by an angle is undetermined over an arc.
fn is_undetermined(turn: f64, arc: f64) -> bool {
    turn >= HALF_TURN || (arc >= HALF_TURN && turn > SAME_ORIENTATION)
}

/// Returns the vector for `rotation`, plus or minus whole turns, that is nearest to `expected`.
fn nearest(rotation: &Rotation3<f64>, expected: &Vector3<f64>) -> Vector3<f64> {
    let shortest = rotation::to_vector(rotation);
    let Some(axis) = shortest.try_normalize(0.0) else { return shortest };
    let turns = ((expected - shortest).dot(&axis) / TAU).round();
    shortest + axis * (turns * TAU)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::{any_trsf, assert_near};
    use crate::{InterpolationError, Trsf, interpolate_c};

    /// Returns a pose on a horizontal circle with a radius of 100 mm about {500, 0, 200}.
    fn on_circle(angle: f64, angles: [f64; 3]) -> Trsf {
        let (sin, cos) = crate::degrees::sin_cos(angle);
        Trsf::new([500.0 + 100.0 * cos, 100.0 * sin, 200.0], angles)
    }

    fn through(places: [Trsf; 3]) -> Result<Arc, ArcError> {
        let [start, intermediate, end] = places.map(|place| place.isometry());
        Arc::through(&start, &intermediate, &end)
    }

    fn assert_at(places: [Trsf; 3], fraction: f64, expected: &Trsf) {
        let [start, intermediate, end] = places;
        let place = interpolate_c(&start, &intermediate, &end, fraction).unwrap();
        assert!(crate::testing::near(&place, expected), "{place:?} is not {expected:?}");
    }

    #[test]
    fn the_middle_is_half_of_the_arc_wherever_the_intermediate_place_is() {
        for intermediate in [10.0, 90.0, 160.0, 170.0] {
            let places = [0.0, intermediate, 180.0].map(|angle| on_circle(angle, [180.0, 0.0, 0.0]));
            assert_at(places, 0.5, &on_circle(90.0, [180.0, 0.0, 0.0]));
            assert_at(places, -0.5, &on_circle(-90.0, [180.0, 0.0, 0.0]));
            assert_at(places, 1.5, &on_circle(270.0, [180.0, 0.0, 0.0]));
        }
    }

    #[test]
    fn the_ends_are_the_places_as_they_are_written() {
        let [start, middle, end] = [0.0, 50.0, 90.0].map(|angle| on_circle(angle, [0.0, 0.0, 400.0]));
        assert_eq!(interpolate_c(&start, &middle, &end, 0.0), Ok(start));
        assert_eq!(interpolate_c(&start, &middle, &end, 1.0), Ok(end));
        for outside in [-1.0, 2.0, f64::NAN] {
            assert_eq!(interpolate_c(&start, &middle, &end, outside), Err(InterpolationError::Fraction));
        }
    }

    #[test]
    fn an_orientation_that_follows_the_circle_follows_it_all_the_way() {
        let follow = |angle| on_circle(angle, [0.0, 0.0, angle]);
        for (intermediate, end) in [(60.0, 100.0), (150.0, 300.0), (160.0, 330.0), (100.0, 200.0)] {
            for fraction in [-0.5, 0.1, 0.5, 0.9, 1.5] {
                assert_at([follow(0.0), follow(intermediate), follow(end)], fraction, &follow(end * fraction));
            }
        }
    }

    #[test]
    fn positions_that_are_too_close_make_no_arc() {
        let [a, b, c] = [0.0, 90.0, 180.0].map(|angle| on_circle(angle, [0.0; 3]));
        let beside = |place: Trsf, by| Trsf { z: place.z + by, ..place };
        assert_eq!(through([a, b, a]).err(), Some(ArcError::TooClose));
        assert_eq!(through([a, beside(a, 0.0009), c]).err(), Some(ArcError::TooClose));
        assert_eq!(through([a, b, beside(b, 0.0009)]).err(), Some(ArcError::TooClose));
        assert!(through([a, beside(a, 0.0011), c]).is_ok());
    }

    #[test]
    fn positions_on_a_line_make_no_arc() {
        let at = |x, y| Trsf::new([x, y, 0.0], [0.0; 3]);
        assert_eq!(through([at(0.0, 0.0), at(100.0, 0.0), at(200.0, 0.0)]).err(), Some(ArcError::Collinear));
        assert_eq!(through([at(0.0, 0.0), at(200.0, 0.0), at(100.0, 0.0)]).err(), Some(ArcError::Collinear));
        assert_eq!(through([at(0.0, 0.0), at(100.0, 0.9e-4), at(200.0, 1e-4)]).err(), Some(ArcError::Collinear));
        assert!(through([at(0.0, 0.0), at(100.0, 1.1e-4), at(200.0, 0.0)]).is_ok());
    }

    #[test]
    fn an_orientation_half_a_turn_away_is_not_determined() {
        let places = |middle| [on_circle(0.0, [0.0; 3]), on_circle(90.0, middle), on_circle(100.0, [0.0; 3])];
        assert_eq!(through(places([0.0, 0.0, 180.0])).err(), Some(ArcError::Orientation));
        assert_eq!(through(places([0.0, 0.0, 179.9995])).err(), Some(ArcError::Orientation));
        assert!(through(places([0.0, 0.0, 179.99])).is_ok());
    }

    #[test]
    fn half_a_circle_needs_one_orientation() {
        let places = |turn| [0.0, 180.0, 200.0].map(|angle| on_circle(angle, [0.0, 0.0, turn * angle]));
        assert_eq!(through(places(0.1)).err(), Some(ArcError::Orientation));
        assert!(through(places(0.0)).is_ok());
        let end = [0.0, 170.0, 351.0].map(|angle| on_circle(angle, [0.0, 0.0, angle / 10.0]));
        assert_eq!(through(end).err(), Some(ArcError::Orientation));
    }

    /// Three poses whose orientations differ by less than a quarter turn about one axis.
    fn mild() -> impl Strategy<Value = [Trsf; 3]> {
        let angle = || (-50.0..50.0_f64, -50.0..50.0_f64, -50.0..50.0_f64).prop_map(|(x, y, z)| [x, y, z]);
        [any_trsf(), any_trsf(), any_trsf()].prop_flat_map(move |places| {
            let turned = move |place: Trsf| angle().prop_map(move |a| Trsf::new([place.x, place.y, place.z], a));
            places.map(turned)
        })
    }

    proptest! {
        #[test]
        fn an_arc_meets_its_places_and_keeps_to_its_circle(places in mild()) {
            let Ok(arc) = through(places) else { return Ok(()) };
            let part = arc.circle.angle_to(&places[1].translation()) / arc.angle;
            prop_assert!(0.0 < part && part < 1.0);
            prop_assume!(arc.circle.radius.norm() < 1e5);
            for (fraction, place) in [0.0, part, 1.0].into_iter().zip(places) {
                prop_assert!((arc.at(fraction).translation.vector - place.translation()).amax() < 1e-7);
                let turned = Trsf::new([0.0; 3], Trsf::from(arc.at(fraction)).angles());
                assert_near(&turned, &Trsf::new([0.0; 3], place.angles()))?;
            }
            let centre = arc.circle.first - arc.circle.radius;
            let out = (arc.at(0.3).translation.vector - centre).norm();
            prop_assert!((out - arc.circle.radius.norm()).abs() < 1e-7);
        }

        #[test]
        fn an_orientation_that_stays_the_same_stays_so(places in mild(), fraction in -0.9..1.9) {
            let places = places.map(|place| Trsf::new([place.x, place.y, place.z], [10.0, 20.0, 30.0]));
            let Ok(arc) = through(places) else { return Ok(()) };
            prop_assert_eq!(Trsf::from(arc.at(fraction)).angles(), [10.0, 20.0, 30.0]);
        }
    }
}
