//! Two circular arcs that join two positions with given directions (`blend = Cartesian`).

use nalgebra::Vector3;

/// Below this sine of half the turn an arc counts as a straight line, in which the error is below 1e-9 mm a metre.
const STRAIGHT: f64 = 1e-9;

/// A curve of two arcs with a common tangent where they meet, at equal distances along the tangents of its ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Biarc {
    arcs: [Arc; 2],
}

/// A circular arc, or a straight line.
#[derive(Clone, Copy, Debug)]
struct Arc {
    start: Vector3<f64>,
    /// Of length 1.
    direction: Vector3<f64>,
    /// Towards the centre; of length 1, or zero for a straight line.
    inwards: Vector3<f64>,
    /// In mm.
    radius: f64,
    /// In mm.
    length: f64,
    end: Vector3<f64>,
}

impl Biarc {
    /// From `start` along the unit vector `leaving` to `end`, which is reached along the unit vector `reaching`.
    ///
    /// None where no such curve of less than half a turn for each arc exists: the direction is reversed.
    pub(crate) fn between(
        start: &Vector3<f64>,
        leaving: &Vector3<f64>,
        end: &Vector3<f64>,
        reaching: &Vector3<f64>,
    ) -> Option<Self> {
        let chord = end - start;
        let handle = handle(&chord, leaving, reaching)?;
        let joint = (start + leaving * handle + end - reaching * handle) / 2.0;
        let middle = (joint - start - leaving * handle).try_normalize(0.0)?;
        let arcs = [Arc::between(start, leaving, &joint), Arc::between(&joint, &middle, end)];
        Some(Self { arcs }).filter(|biarc| biarc.arcs.iter().all(|arc| arc.length > 0.0))
    }

    /// In mm.
    pub(crate) fn length(&self) -> f64 {
        self.arcs.iter().map(|arc| arc.length).sum()
    }

    /// The share of the length at which the arcs meet.
    pub(crate) fn junction(&self) -> f64 {
        let [first, _] = &self.arcs;
        first.length / self.length()
    }

    /// The position after a share of the length.
    pub(crate) fn at(&self, share: f64) -> Vector3<f64> {
        let [first, second] = &self.arcs;
        let way = share * self.length();
        if way <= first.length { first.at(way) } else { second.at((way - first.length).min(second.length)) }
    }
}

/// The distance d along both tangents: the corners at d from the ends are 2·d apart.
fn handle(chord: &Vector3<f64>, leaving: &Vector3<f64>, reaching: &Vector3<f64>) -> Option<f64> {
    let (square, linear) = (2.0 * (1.0 - leaving.dot(reaching)), 2.0 * chord.dot(&(leaving + reaching)));
    let constant = chord.norm_squared();
    // square·d² + linear·d - constant = 0, in the form that stays exact where `square` vanishes.
    let root = (linear * linear + 4.0 * square * constant).sqrt();
    Some(2.0 * constant / (linear + root)).filter(|handle| handle.is_finite() && *handle > 0.0)
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

    /// The position after a way in mm.
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

    fn corner(turn: f64, leave: f64, reach: f64) -> Biarc {
        let (sin, cos) = val3_geometry::degrees::sin_cos(turn);
        let direction = Vector3::new(cos, sin, 0.0);
        Biarc::between(&Vector3::new(-leave, 0.0, 0.0), &Vector3::x(), &(direction * reach), &direction).unwrap()
    }

    /// Section (a) of the motion model: one circle of radius d / tan(turn / 2).
    #[test]
    fn equal_distances_give_one_circle() {
        for (turn, radius, deviation) in [(45.0, 120.7107, 9.9456), (90.0, 50.0, 20.7107)] {
            let biarc = corner(turn, 50.0, 50.0);
            assert!(biarc.arcs.iter().all(|arc| (arc.radius - radius).abs() < 1e-4));
            assert!((biarc.at(0.5).norm() - deviation).abs() < 1e-4);
        }
    }

    /// Section (a) of the motion model.
    #[test]
    fn unequal_distances_give_two_circles() {
        let biarc = corner(90.0, 50.0, 200.0);
        let [first, second] = biarc.arcs.map(|arc| arc.radius);
        assert!((first - 58.992188).abs() < 1e-6 && (second - 1051.085931).abs() < 1e-6, "{first} {second}");
        assert!((biarc.arcs[0].end - Vector3::new(8.514322, 66.485678, 0.0)).norm() < 1e-6);
    }

    #[test]
    fn a_straight_corner_stays_straight() {
        let biarc = corner(0.0, 30.0, 70.0);
        assert!((biarc.length() - 100.0).abs() < 1e-9);
        assert!((biarc.at(0.3) - Vector3::zeros()).norm() < 1e-9);
    }

    #[test]
    fn a_reversal_has_no_curve() {
        let back = Biarc::between(
            &Vector3::new(-50.0, 0.0, 0.0),
            &Vector3::x(),
            &Vector3::new(-50.0, 0.0, 0.0),
            &-Vector3::x(),
        );
        assert!(back.is_none());
    }

    proptest! {
        #[test]
        fn both_ends_and_both_tangents_are_met(turn in 1.0..170.0_f64, leave in 1.0..300.0_f64, reach in 1.0..300.0_f64) {
            let biarc = corner(turn, leave, reach);
            let (sin, cos) = val3_geometry::degrees::sin_cos(turn);
            let direction = Vector3::new(cos, sin, 0.0);
            prop_assert!((biarc.at(0.0) - Vector3::new(-leave, 0.0, 0.0)).norm() < 1e-9);
            prop_assert!((biarc.at(1.0) - direction * reach).norm() < 1e-9);
            let step = 1e-6;
            let start = (biarc.at(step) - biarc.at(0.0)).normalize();
            let end = (biarc.at(1.0) - biarc.at(1.0 - step)).normalize();
            prop_assert!((start - Vector3::x()).norm() < 1e-4 && (end - direction).norm() < 1e-4);
            prop_assert!((0..=100).all(|part| biarc.at(f64::from(part) / 100.0).z == 0.0));
        }
    }
}
