//! Biarc: two circular arcs that join two positions with given directions (`blend = Cartesian`).

use nalgebra::Vector3;

/// Sine of half the turn below which an arc counts as a straight line. The error is then below 1e-9 mm per metre.
const STRAIGHT: f64 = 1e-9;

/// Two arcs with a common tangent at their junction.
///
/// The control polygon has one corner on each end tangent, with a given ratio of the handle lengths (section (a) of the
/// motion model). If the end tangents meet in a corner and the ratio equals the ratio of the distances to this corner,
/// the polygon, and with it the curve, stays within the triangle formed by the ends and the corner.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Biarc {
    arcs: [Arc; 2],
}

/// End of a [`Biarc`].
pub(crate) struct BiarcEnd {
    pub(crate) position: Vector3<f64>,
    /// Unit vector: direction of the curve at this end.
    pub(crate) direction: Vector3<f64>,
    /// Distance to the corner in mm, above 0.
    pub(crate) distance: f64,
}

/// Circular arc or straight line.
#[derive(Clone, Copy, Debug)]
struct Arc {
    start: Vector3<f64>,
    /// Unit vector: direction at the start.
    direction: Vector3<f64>,
    /// Unit vector towards the centre; zero for a straight line.
    inwards: Vector3<f64>,
    /// Radius in mm; 0 for a straight line.
    radius: f64,
    /// Arc length in mm.
    length: f64,
    end: Vector3<f64>,
}

impl Biarc {
    /// Curve between two ends. The handle lengths, from each end to its corner of the control polygon, are proportional
    /// to `distance`.
    ///
    /// `None` if the direction is reversed, so that no such curve with less than half a turn per arc exists.
    pub(crate) fn between(start: &BiarcEnd, end: &BiarcEnd) -> Option<Self> {
        let share = handle_share(start, end)?;
        let [first, last] = [share * start.distance, share * end.distance];
        let [leaving, arriving] = [start.position + start.direction * first, end.position - end.direction * last];
        let joint = (leaving * last + arriving * first) / (first + last);
        let middle = (arriving - leaving).try_normalize(0.0)?;
        let arcs =
            [Arc::between(&start.position, &start.direction, &joint), Arc::between(&joint, &middle, &end.position)];
        Some(Self { arcs }).filter(|biarc| biarc.arcs.iter().all(|arc| arc.length > 0.0))
    }

    /// Curve length in mm.
    pub(crate) fn length(&self) -> f64 {
        self.arcs.iter().map(|arc| arc.length).sum()
    }

    /// Length of the first arc in mm.
    pub(crate) fn junction(&self) -> f64 {
        let [first, _] = &self.arcs;
        first.length
    }

    /// Position at an arc length in mm from the start.
    pub(crate) fn at(&self, way: f64) -> Vector3<f64> {
        let [first, second] = &self.arcs;
        if way <= first.length { first.at(way) } else { second.at((way - first.length).min(second.length)) }
    }
}

/// Handle length as a fraction of the end's `distance`. It follows from the condition that the distance between the
/// corners of the control polygon equals the sum of the two handles.
fn handle_share(start: &BiarcEnd, end: &BiarcEnd) -> Option<f64> {
    let chord = end.position - start.position;
    let legs = start.direction * start.distance + end.direction * end.distance;
    let square = 2.0 * start.distance * end.distance * (1.0 - start.direction.dot(&end.direction));
    let (linear, constant) = (chord.dot(&legs), chord.norm_squared());
    // square·k² + 2·linear·k - constant = 0, in the form that stays exact if `square` is close to 0.
    let root = (linear * linear + square * constant).sqrt();
    Some(constant / (linear + root)).filter(|share| share.is_finite() && *share > 0.0)
}

impl Arc {
    fn between(start: &Vector3<f64>, direction: &Vector3<f64>, end: &Vector3<f64>) -> Self {
        let chord = end - start;
        let across = chord - direction * chord.dot(direction);
        let (along, aside) = (chord.dot(direction), across.norm());
        // The angle between the chord and the tangent is half the turn.
        let sine = aside / chord.norm();
        if sine < STRAIGHT || !sine.is_finite() {
            let length = chord.norm();
            return Self {
                start: *start,
                direction: *direction,
                inwards: Vector3::zeros(),
                radius: 0.0,
                length,
                end: *end,
            };
        }
        let half = val3_geometry::degrees::atan2(aside, along).to_radians();
        let radius = chord.norm() / (2.0 * sine);
        Self {
            start: *start,
            direction: *direction,
            inwards: across / aside,
            radius,
            length: 2.0 * half * radius,
            end: *end,
        }
    }

    /// Position at an arc length in mm.
    fn at(&self, way: f64) -> Vector3<f64> {
        if way >= self.length {
            return self.end;
        }
        if self.radius == 0.0 {
            return self.start + self.direction * way;
        }
        let (sin, cos) = val3_geometry::degrees::sin_cos((way / self.radius / 2.0).to_degrees());
        self.start + (self.direction * cos + self.inwards * sin) * (2.0 * sin * self.radius)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Biarc around a corner in the origin, with a turn in degrees.
    fn corner(turn: f64, leave: f64, reach: f64) -> Option<Biarc> {
        let (sin, cos) = val3_geometry::degrees::sin_cos(turn);
        let direction = Vector3::new(cos, sin, 0.0);
        let start = BiarcEnd { position: Vector3::x() * -leave, direction: Vector3::x(), distance: leave };
        let end = BiarcEnd { position: direction * reach, direction, distance: reach };
        Biarc::between(&start, &end)
    }

    /// Section (a) of the motion model: one circle of radius d / tan(turn / 2).
    #[test]
    fn equal_distances_give_one_circle() {
        for (turn, radius, deviation) in [(45.0, 120.7107, 9.9456), (90.0, 50.0, 20.7107)] {
            let biarc = corner(turn, 50.0, 50.0).unwrap();
            assert!(biarc.arcs.iter().all(|arc| (arc.radius - radius).abs() < 1e-4));
            assert!((biarc.at(biarc.length() / 2.0).norm() - deviation).abs() < 1e-4);
        }
    }

    /// Section (a) of the motion model.
    #[test]
    fn unequal_distances_give_two_circles() {
        let biarc = corner(90.0, 50.0, 200.0).unwrap();
        let [first, second] = biarc.arcs.map(|arc| arc.radius);
        assert!((first - 28.941770).abs() < 1e-6 && (second - 734.232922).abs() < 1e-6, "{first} {second}");
        assert!((biarc.arcs[0].end - Vector3::new(-21.922359, 21.922359, 0.0)).norm() < 1e-6);
    }

    #[test]
    fn a_straight_corner_stays_straight() {
        let biarc = corner(0.0, 30.0, 70.0).unwrap();
        assert!((biarc.length() - 100.0).abs() < 1e-9);
        assert!((biarc.at(30.0)).norm() < 1e-9);
    }

    #[test]
    fn a_reversal_has_no_curve() {
        assert!(corner(180.0, 50.0, 50.0).is_none());
    }

    proptest! {
        #[test]
        fn both_ends_and_both_tangents_are_met(turn in 1.0..170.0_f64, leave in 1.0..300.0_f64, reach in 1.0..300.0_f64) {
            let biarc = corner(turn, leave, reach).unwrap();
            let length = biarc.length();
            let (sin, cos) = val3_geometry::degrees::sin_cos(turn);
            let direction = Vector3::new(cos, sin, 0.0);
            prop_assert!((biarc.at(0.0) - Vector3::new(-leave, 0.0, 0.0)).norm() < 1e-9);
            prop_assert!((biarc.at(length) - direction * reach).norm() < 1e-9);
            let step = 1e-9 * length;
            let start = (biarc.at(step) - biarc.at(0.0)).normalize();
            let end = (biarc.at(length) - biarc.at(length - step)).normalize();
            prop_assert!((start - Vector3::x()).norm() < 1e-4 && (end - direction).norm() < 1e-4);
            prop_assert!((0..=100).all(|part| biarc.at(length * f64::from(part) / 100.0).z == 0.0));
        }

        /// In coordinates along both tangents, the triangle of the corner is `along >= 0`, `along + along <= 1`.
        #[test]
        fn the_curve_stays_within_the_triangle_of_its_corner(
            turn in 1.0..179.0_f64,
            leave in 0.1..300.0_f64,
            reach in 0.1..300.0_f64,
        ) {
            let biarc = corner(turn, leave, reach).unwrap();
            let (sin, cos) = val3_geometry::degrees::sin_cos(turn);
            for part in 0..=200 {
                let position = biarc.at(biarc.length() * f64::from(part) / 200.0);
                let on_second = position.y / sin;
                let on_first = on_second * cos - position.x;
                prop_assert!(on_first > -1e-9 && on_second > -1e-9);
                prop_assert!(on_first / leave + on_second / reach < 1.0 + 1e-9);
            }
        }
    }
}
