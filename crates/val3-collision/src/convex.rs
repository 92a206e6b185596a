//! Distances between convex shapes, each verified by a separating gap.
//!
//! The library's search for the nearest points may end before it has found them, for example if two shapes touch with
//! corners or faces. It may also report shapes with many faces as disjoint when it reaches its iteration limit. Each
//! result is therefore verified: a distance is accepted only with a *gap* of this width, which is a pair of parallel
//! planes that separate the shapes. If a result cannot be verified, the search is repeated from other directions.

use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query::details::{
    closest_points_support_map_support_map_with_params, contact_support_map_support_map_with_params,
};
use parry3d_f64::query::gjk::{GJKResult, VoronoiSimplex};
use parry3d_f64::shape::SupportMap;

/// Largest accepted difference between a distance and its gap, in mm.
const PRECISION: f64 = 1e-4;

/// Smallest accepted volume in mm³ between the origin and a face of a tetrahedron, times six. It is far above rounding
/// errors.
const VOLUME: f64 = 1e-3;

/// Result for two convex shapes, with points in the frame of the first shape.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Found {
    /// The gap is greater than the limit.
    Beyond,
    /// Nearest points.
    Apart([Vector; 2]),
    /// The shapes overlap or touch.
    Overlap,
}

/// Two convex shapes in a common frame, which is the frame of the first shape.
#[derive(Clone, Copy)]
pub(crate) struct ConvexPair<'s> {
    pub(crate) first: &'s dyn SupportMap,
    pub(crate) second: &'s dyn SupportMap,
    /// Pose of the second shape in the common frame.
    pub(crate) pose: &'s Pose,
}

impl ConvexPair<'_> {
    /// Returns the nearest points of both shapes, or their overlap.
    pub(crate) fn nearest(&self, limit: f64) -> Found {
        let mut best: Option<Proof> = None;
        for direction in self.directions() {
            let proof = match self.search(direction, limit) {
                Search::Bounded(proof) => proof,
                Search::CommonPoint => return Found::Overlap,
                Search::Undecided => continue,
            };
            if proof.gap > limit {
                return Found::Beyond;
            }
            if proof.distance() - proof.gap <= PRECISION {
                return proof.found();
            }
            best = Some(best.filter(|best| best.gap >= proof.gap).unwrap_or(proof));
        }
        match best {
            // Not exact, but never greater than the actual distance.
            Some(proof) if proof.gap > 0.0 => proof.shortened().found(),
            _ => Found::Overlap,
        }
    }

    /// Returns the depth of an overlap: the length of the shortest shift that separates the shapes, with its end
    /// points.
    pub(crate) fn overlap(&self) -> (f64, [Vector; 2]) {
        let mut shifts: Vec<Vector> = self.directions().collect();
        for direction in self.directions() {
            let Some(Penetration { normal, depth }) = self.penetration(direction) else { continue };
            shifts.push(normal);
            if -self.gap(normal) - depth <= PRECISION {
                break;
            }
        }
        let normal = shifts.into_iter().max_by(|a, b| self.gap(*a).total_cmp(&self.gap(*b))).unwrap_or(Vector::Z);
        (-self.gap(normal), self.extremes(normal))
    }

    /// Returns unit vectors as start directions of a search: from centre to centre, and along the axes of both frames.
    fn directions(&self) -> impl Iterator<Item = Vector> {
        let axes = [Vector::X, Vector::Y, Vector::Z];
        let axes = axes.into_iter().chain(axes.map(|axis| self.pose.rotation * axis));
        let centres = self.pose.translation.try_normalize();
        centres.into_iter().chain(axes).flat_map(|direction| [direction, -direction])
    }

    /// Searches for the nearest points.
    fn search(&self, direction: Vector, limit: f64) -> Search {
        let mut simplex = VoronoiSimplex::new();
        let ConvexPair { first, second, pose } = *self;
        let begin = Some(-direction);
        match closest_points_support_map_support_map_with_params(pose, first, second, limit, &mut simplex, begin) {
            GJKResult::ClosestPoints(on_first, on_second, _) => {
                let normal = (on_second - on_first).try_normalize().unwrap_or(direction);
                Search::Bounded(Proof { points: [on_first, on_second], gap: self.gap(normal) })
            }
            GJKResult::NoIntersection(normal) | GJKResult::Proximity(normal) => {
                // The library's normal may point at either shape.
                let normal = if self.gap(normal) > self.gap(-normal) { normal } else { -normal };
                Search::Bounded(Proof { points: self.extremes(normal), gap: self.gap(normal) })
            }
            GJKResult::Intersection if encloses_origin(&simplex) => Search::CommonPoint,
            GJKResult::Intersection => Search::Undecided,
        }
    }

    /// Returns the library's result for the shortest shift that separates both shapes.
    fn penetration(&self, direction: Vector) -> Option<Penetration> {
        let mut simplex = VoronoiSimplex::new();
        let ConvexPair { first, second, pose } = *self;
        match contact_support_map_support_map_with_params(pose, first, second, 0.0, &mut simplex, Some(direction)) {
            GJKResult::ClosestPoints(on_first, on_second, normal) => {
                let normal = normal.try_normalize()?;
                Some(Penetration { normal, depth: normal.dot(on_first - on_second) })
            }
            _ => None,
        }
    }

    /// Returns the signed distance between two parallel planes with this normal: one at the end of the first shape, the
    /// other at the beginning of the second shape. It is a lower bound of the distance between the shapes.
    fn gap(&self, normal: Vector) -> f64 {
        let [on_first, on_second] = self.extremes(normal);
        normal.dot(on_second - on_first)
    }

    /// Returns the extreme points along a direction: the farthest point of the first shape, and the nearest point of
    /// the second.
    fn extremes(&self, normal: Vector) -> [Vector; 2] {
        [self.first.local_support_point(normal), self.second.support_point(self.pose, -normal)]
    }
}

/// Shortest shift that separates two shapes, as the library has found it.
struct Penetration {
    /// Direction of the shift of the second shape.
    normal: Vector,
    /// Distance in mm between the origin and the nearest face of a polytope inside the difference of both shapes. It is
    /// a lower bound of the depth; a gap is an upper bound.
    depth: f64,
}

/// Result of a search for the nearest points.
enum Search {
    /// Bounds of the distance.
    Bounded(Proof),
    /// The shapes have a common point.
    CommonPoint,
    /// The library reports an overlap without a proof, or has failed.
    Undecided,
}

/// Whether the origin is inside the tetrahedron at which a search has ended. Its corners are differences of points of
/// both shapes, so the shapes then have a common point.
fn encloses_origin(simplex: &VoronoiSimplex) -> bool {
    if simplex.dimension() != 3 {
        return false;
    }
    let [a, b, c, d] = [0, 1, 2, 3].map(|corner| simplex.point(corner).point);
    let volumes = [b.cross(c).dot(d), -a.cross(c).dot(d), a.cross(b).dot(d), -a.cross(b).dot(c)];
    volumes.iter().all(|volume| *volume > VOLUME) || volumes.iter().all(|volume| *volume < -VOLUME)
}

/// Upper and lower bound of a distance: a point on each shape, and a gap between the shapes.
#[derive(Debug, Clone, Copy)]
struct Proof {
    points: [Vector; 2],
    gap: f64,
}

impl Proof {
    fn distance(&self) -> f64 {
        let [on_first, on_second] = self.points;
        (on_second - on_first).length()
    }

    fn found(self) -> Found {
        if self.gap > 0.0 { Found::Apart(self.points) } else { Found::Overlap }
    }

    /// Moves the second point so that the distance of the points equals the gap.
    fn shortened(self) -> Self {
        let [on_first, on_second] = self.points;
        let points = [on_first, on_first + (on_second - on_first) * (self.gap / self.distance())];
        Self { points, ..self }
    }
}
