//! Distances between capsules in closed form: the distance between two line segments, minus both radii.

use val3_geometry::{IsometryMatrix3, Vector3};

/// The points within a radius of a line segment. A sphere has a segment of length 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Capsule {
    pub(crate) from: Vector3<f64>,
    pub(crate) to: Vector3<f64>,
    pub(crate) radius: f64,
}

impl Capsule {
    pub(crate) fn placed(&self, pose: &IsometryMatrix3<f64>) -> Self {
        let place = |point: &Vector3<f64>| pose.rotation * point + pose.translation.vector;
        Self { from: place(&self.from), to: place(&self.to), radius: self.radius }
    }

    /// Returns the nearest points of both axes.
    pub(crate) fn nearest(&self, other: &Self) -> [Vector3<f64>; 2] {
        let (along, across) = (self.to - self.from, other.to - other.from);
        let offset = self.from - other.from;
        let (a, e, f) = (along.norm_squared(), across.norm_squared(), across.dot(&offset));
        let (b, c) = (along.dot(&across), along.dot(&offset));
        let share = |of: f64, length: f64| if length > 0.0 { (of / length).clamp(0.0, 1.0) } else { 0.0 };
        // Nearest point of the infinite lines, limited to the first segment. For parallel lines, any point is valid.
        let cross = a * e - b * b;
        let s = if cross > PARALLEL * a * e { ((b * f - c * e) / cross).clamp(0.0, 1.0) } else { 0.0 };
        // Nearest point of the second segment to this point, then of the first segment to that point.
        let t = share(b * s + f, e);
        let s = share(b * t - c, a);
        [self.from + along * s, other.from + across * t]
    }
}

/// Axes are parallel if the squared sine of their angle is below this value.
const PARALLEL: f64 = 1e-14;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::point;

    fn capsule() -> impl Strategy<Value = Capsule> {
        (point(300.0), point(300.0)).prop_map(|(from, to)| Capsule { from, to, radius: 10.0 })
    }

    proptest! {
        /// Other points on the axes are not nearer than the computed points.
        #[test]
        fn no_points_are_nearer(a in capsule(), b in capsule(), s in 0.0..1.0_f64, t in 0.0..1.0_f64) {
            let [on_a, on_b] = a.nearest(&b);
            let other: Vector3<f64> = (a.from + (a.to - a.from) * s) - (b.from + (b.to - b.from) * t);
            prop_assert!((on_a - on_b).norm() <= other.norm() + 1e-9);
        }

        /// Parallel axes, one of which may be a point.
        #[test]
        fn parallel_axes_have_their_distance(a in capsule(), shift in 0.0..500.0_f64, share in 0.0..1.0_f64) {
            let along = a.to - a.from;
            prop_assume!(along.norm() > 1.0);
            let across = along.cross(&Vector3::new(0.3, -0.5, 0.8)).normalize() * shift;
            let b = Capsule { from: a.from + across, to: a.from + along * share + across, radius: 1.0 };
            for [on_a, on_b] in [a.nearest(&b), b.nearest(&a)] {
                let distance: f64 = Vector3::norm(&(on_a - on_b));
                prop_assert!((distance - shift).abs() < 1e-6, "{on_a} {on_b}");
            }
        }
    }
}
