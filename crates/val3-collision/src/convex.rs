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
    /// Estimated direction from the first shape to the second, with any length. Searches start in this direction.
    pub(crate) towards: Vector,
}

impl ConvexPair<'_> {
    /// Returns the nearest points or the overlap of the shapes. Pairs whose gap is greater than `limit` are beyond it.
    pub(crate) fn nearest(&self, limit: f64) -> Found {
        let mut best: Option<Proof> = None;
        for direction in self.directions() {
            let Some(proof) = self.search(direction, limit) else { continue };
            if proof.gap > limit {
                return Found::Beyond;
            }
            if proof.distance() - proof.gap <= PRECISION {
                return proof.found();
            }
            best = Some(best.filter(|best| best.gap >= proof.gap).unwrap_or(proof));
        }
        match best {
            // The gap is inexact, but never greater than the actual distance.
            Some(proof) if proof.gap > 0.0 => proof.shortened().found(),
            _ => Found::Overlap,
        }
    }

    /// Returns the depth of the overlap, which is the length of the shortest separating shift, and the extreme points
    /// of both shapes along this shift.
    pub(crate) fn overlap(&self) -> (f64, [Vector; 2]) {
        let found = self.directions().filter_map(|direction| self.penetration(direction));
        let shifts = self.directions().chain(found);
        let normal = shifts.max_by(|a, b| self.gap(*a).total_cmp(&self.gap(*b))).unwrap_or(Vector::Z);
        (-self.gap(normal), self.extremes(normal))
    }

    /// Returns the start directions of searches, as unit vectors: from shape to shape, and along the axes of both frames.
    fn directions(&self) -> impl Iterator<Item = Vector> {
        let axes = [Vector::X, Vector::Y, Vector::Z];
        let axes = axes.into_iter().chain(axes.map(|axis| self.pose.rotation * axis));
        self.towards.try_normalize().into_iter().chain(axes).flat_map(|direction| [direction, -direction])
    }

    /// Searches for the nearest points; `None` if the search found an overlap or failed.
    fn search(&self, direction: Vector, limit: f64) -> Option<Proof> {
        let mut simplex = VoronoiSimplex::new();
        let ConvexPair { first, second, pose, .. } = *self;
        let begin = Some(-direction);
        match closest_points_support_map_support_map_with_params(pose, first, second, limit, &mut simplex, begin) {
            GJKResult::ClosestPoints(on_first, on_second, _) => {
                let normal = (on_second - on_first).try_normalize().unwrap_or(direction);
                Some(Proof { points: [on_first, on_second], gap: self.gap(normal) })
            }
            GJKResult::NoIntersection(normal) | GJKResult::Proximity(normal) => {
                // The library's normal may point at either shape.
                let normal = if self.gap(normal) > self.gap(-normal) { normal } else { -normal };
                Some(Proof { points: self.extremes(normal), gap: self.gap(normal) })
            }
            GJKResult::Intersection => None,
        }
    }

    /// Returns the library's direction of the shortest shift that separates both shapes.
    fn penetration(&self, direction: Vector) -> Option<Vector> {
        let mut simplex = VoronoiSimplex::new();
        let ConvexPair { first, second, pose, .. } = *self;
        match contact_support_map_support_map_with_params(pose, first, second, 0.0, &mut simplex, Some(direction)) {
            GJKResult::ClosestPoints(_, _, normal) => normal.try_normalize(),
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
