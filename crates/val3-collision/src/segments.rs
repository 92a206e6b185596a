//! Nearest points between a line segment and another segment or a triangle, in closed form.

use val3_geometry::Vector3;

/// Segments are parallel if the squared sine of their angle is below this value.
const PARALLEL: f64 = 1e-14;

/// A line segment. Its ends may be the same point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LineSegment {
    pub(crate) from: Vector3<f64>,
    pub(crate) to: Vector3<f64>,
}

impl LineSegment {
    /// Returns the nearest points: one on this segment, one on the other.
    pub(crate) fn nearest(&self, other: &Self) -> [Vector3<f64>; 2] {
        let (along, across) = (self.to - self.from, other.to - other.from);
        let offset = self.from - other.from;
        let (a, e, f) = (along.norm_squared(), across.norm_squared(), across.dot(&offset));
        let (b, c) = (along.dot(&across), along.dot(&offset));
        // Nearest point of the infinite lines, limited to the first segment. For parallel lines, any point is valid.
        let cross = a * e - b * b;
        let s = if cross > PARALLEL * a * e { ((b * f - c * e) / cross).clamp(0.0, 1.0) } else { 0.0 };
        // Nearest point of the second segment to this point, then of the first segment to that point.
        let t = share(b * s + f, e);
        let s = share(b * t - c, a);
        [self.from + along * s, other.from + across * t]
    }

    /// Returns the distance to a point.
    pub(crate) fn distance_to(&self, point: &Vector3<f64>) -> f64 {
        let along = self.to - self.from;
        let s = share(along.dot(&(point - self.from)), along.norm_squared());
        (self.from + along * s - point).norm()
    }

    /// Returns the nearest points: one on this segment, one on the triangle; `None` if both have a common point.
    ///
    /// The point on the triangle is on an edge, or the point on the segment is an end.
    pub(crate) fn nearest_of_triangle(&self, corners: &[Vector3<f64>; 3]) -> Option<[Vector3<f64>; 2]> {
        let prism = Prism::new(corners);
        let normal = prism.normal;
        let heights = [self.from, self.to].map(|end| normal.dot(&(end - corners[0])));
        // A triangle without an area has only edges.
        let area = normal.norm_squared();
        if area > 0.0 && heights[0] * heights[1] < 0.0 {
            let crossing = self.from + (self.to - self.from) * (heights[0] / (heights[0] - heights[1]));
            if prism.contains(&crossing) {
                return None;
            }
        }
        let on_edges = prism.edges.map(|edge| self.nearest(&edge));
        let on_face =
            [self.from, self.to].into_iter().zip(heights).filter(|(end, _)| area > 0.0 && prism.contains(end));
        let on_face = on_face.map(|(end, height)| [end, end - normal * (height / area)]);
        let length = |[on_segment, other]: &[Vector3<f64>; 2]| (other - on_segment).norm_squared();
        let nearest = on_edges.into_iter().chain(on_face).min_by(|one, other| length(one).total_cmp(&length(other)));
        nearest.filter(|points| length(points) > 0.0)
    }
}

/// The infinite prism over a triangle: the points whose perpendicular onto the triangle's plane ends in the triangle.
struct Prism {
    edges: [LineSegment; 3],
    /// Normal of the triangle's plane, whose length is twice the area.
    normal: Vector3<f64>,
}

impl Prism {
    fn new(corners: &[Vector3<f64>; 3]) -> Self {
        let [a, b, c] = *corners;
        let edges = [(a, b), (b, c), (c, a)].map(|(from, to)| LineSegment { from, to });
        Self { edges, normal: (b - a).cross(&(c - a)) }
    }

    fn contains(&self, point: &Vector3<f64>) -> bool {
        let is_left = |edge: &LineSegment| (edge.to - edge.from).cross(&(point - edge.from)).dot(&self.normal) >= 0.0;
        self.edges.iter().all(is_left)
    }
}

/// Returns `of` as a fraction of a length, limited to the range from 0 to 1; 0 if the length is 0.
fn share(of: f64, length: f64) -> f64 {
    if length > 0.0 { (of / length).clamp(0.0, 1.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use parry3d_f64::math::{Pose, Vector};
    use parry3d_f64::shape::{Segment, Triangle};
    use proptest::prelude::*;

    use super::*;
    use crate::convert;
    use crate::convex::{ConvexPair, Found};
    use crate::testing::point;

    fn segment() -> impl Strategy<Value = LineSegment> {
        (point(300.0), point(300.0)).prop_map(|(from, to)| LineSegment { from, to })
    }

    fn distance(points: [Vector3<f64>; 2]) -> f64 {
        (points[1] - points[0]).norm()
    }

    /// Returns the distance that the library's search finds; 0 for a common point.
    fn searched(segment: &LineSegment, corners: &[Vector3<f64>; 3]) -> f64 {
        let [from, to] = [&segment.from, &segment.to].map(convert::vector);
        let [a, b, c] = corners.each_ref().map(convert::vector);
        let (first, second) = (Segment::new(from, to), Triangle::new(a, b, c));
        match (ConvexPair { first: &first, second: &second, pose: &Pose::IDENTITY, towards: Vector::ZERO })
            .nearest(5000.0)
        {
            Found::Beyond => f64::INFINITY,
            Found::Apart([one, other]) => (other - one).length(),
            Found::Overlap => 0.0,
        }
    }

    proptest! {
        /// Other points on the segments are not nearer than the computed points.
        #[test]
        fn no_points_are_nearer(a in segment(), b in segment(), s in 0.0..1.0_f64, t in 0.0..1.0_f64) {
            let other: Vector3<f64> = (a.from + (a.to - a.from) * s) - (b.from + (b.to - b.from) * t);
            prop_assert!(distance(a.nearest(&b)) <= other.norm() + 1e-9);
        }

        /// Parallel segments, one of which may be a point.
        #[test]
        fn parallel_segments_have_their_distance(a in segment(), shift in 0.0..500.0_f64, share in 0.0..1.0_f64) {
            let along = a.to - a.from;
            prop_assume!(along.norm() > 1.0);
            let across = along.cross(&Vector3::new(0.3, -0.5, 0.8)).normalize() * shift;
            let b = LineSegment { from: a.from + across, to: a.from + along * share + across };
            for points in [a.nearest(&b), b.nearest(&a)] {
                prop_assert!((distance(points) - shift).abs() < 1e-6, "{points:?}");
            }
        }

        /// The search has the same result, for triangles of all forms and for segments that are points.
        #[test]
        fn a_triangle_has_the_distance_of_the_search(
            segment in segment(),
            corners in [point(300.0), point(300.0), point(300.0)],
            thin in prop_oneof![Just(1.0), Just(1e-3), Just(0.0)],
            short in prop_oneof![Just(1.0), Just(0.0)],
        ) {
            let segment = LineSegment { to: segment.from + (segment.to - segment.from) * short, ..segment };
            let [a, b, c] = corners;
            let corners = [a, b, a + (b - a) * 0.3 + (c - a) * thin];
            let points = segment.nearest_of_triangle(&corners);
            let found = points.map_or(0.0, distance);
            prop_assert!((found - searched(&segment, &corners)).abs() < 1e-6, "{found} {}", searched(&segment, &corners));
            for corners in [[corners[1], corners[2], corners[0]], [corners[2], corners[1], corners[0]]] {
                let other = segment.nearest_of_triangle(&corners).map_or(0.0, distance);
                prop_assert!((found - other).abs() < 1e-9 * (1.0 + found), "{found} {other}");
            }
        }

        /// Points of the segment and the triangle are not nearer than the computed points.
        #[test]
        fn no_points_of_a_triangle_are_nearer(
            segment in segment(),
            corners in [point(300.0), point(300.0), point(300.0)],
            s in 0.0..1.0_f64,
            t in 0.0..1.0_f64,
            u in 0.0..1.0_f64,
        ) {
            let [a, b, c] = corners;
            let on_triangle = a + ((b - a) * (1.0 - u) + (c - a) * u) * t;
            let on_segment = segment.from + (segment.to - segment.from) * s;
            let found = segment.nearest_of_triangle(&corners).map_or(0.0, distance);
            prop_assert!(found <= distance([on_segment, on_triangle]) + 1e-9);
            prop_assert!(segment.distance_to(&on_triangle) >= found - 1e-9);
        }
    }

    #[test]
    fn a_prism_contains_the_points_over_its_triangle() {
        let corners = [Vector3::zeros(), Vector3::x() * 10.0, Vector3::y() * 10.0];
        for corners in [corners, [corners[1], corners[0], corners[2]]] {
            let prism = Prism::new(&corners);
            for height in [-500.0, 0.0, 500.0] {
                assert!(
                    prism.contains(&Vector3::new(2.0, 7.0, height)) && prism.contains(&Vector3::new(5.0, 5.0, height))
                );
                assert!(
                    !prism.contains(&Vector3::new(6.0, 5.0, height))
                        && !prism.contains(&Vector3::new(2.0, -0.1, height))
                );
            }
        }
    }

    #[test]
    fn a_segment_in_the_plane_of_a_triangle_may_meet_it() {
        let corners = [Vector3::zeros(), Vector3::x() * 10.0, Vector3::y() * 10.0];
        let at = |x: f64, y: f64| Vector3::new(x, y, 0.0);
        let meets = |from, to| LineSegment { from, to }.nearest_of_triangle(&corners).is_none();
        assert!(meets(at(-1.0, 2.0), at(20.0, 2.0)) && meets(at(1.0, 1.0), at(2.0, 2.0)));
        assert!(!meets(at(-1.0, -1.0), at(20.0, -1.0)));
    }
}
