//! Distances between convex shapes, each with its proof.
//!
//! The library's search for the nearest points may end before it has found them, for example where two shapes touch
//! with corners or faces, and may call shapes of many directions disjoint when it has searched for too long. So no
//! answer is taken on trust: a distance needs a *gap*, two parallel planes so far apart that have the shapes on
//! different sides. An answer without a proof is searched for again from other directions.

use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query::details::{
    closest_points_support_map_support_map_with_params, contact_support_map_support_map_with_params,
};
use parry3d_f64::query::gjk::{GJKResult, VoronoiSimplex};
use parry3d_f64::shape::SupportMap;

/// Largest difference between a distance and its gap, in mm.
const PRECISION: f64 = 1e-4;

/// How near two convex shapes are, with points in the frame of the first.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Found {
    /// A gap is greater than the limit.
    Beyond,
    /// Nearest points.
    Apart([Vector; 2]),
    /// They overlap or touch.
    Overlap,
}

/// Two convex shapes. The first one's frame is the common one.
#[derive(Clone, Copy)]
pub(crate) struct ConvexPair<'s> {
    pub(crate) first: &'s dyn SupportMap,
    pub(crate) second: &'s dyn SupportMap,
    /// Pose of the second shape.
    pub(crate) pose: &'s Pose,
}

impl ConvexPair<'_> {
    /// Returns how near both are.
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
            // Not exact, but never farther than they are.
            Some(proof) if proof.gap > 0.0 => proof.shortened().found(),
            _ => Found::Overlap,
        }
    }

    /// Returns the length of the shortest shift that separates shapes which overlap, and points at its ends.
    pub(crate) fn overlap(&self) -> (f64, [Vector; 2]) {
        let found = self.directions().filter_map(|direction| self.penetration(direction));
        let shifts = self.directions().chain(found);
        let normal = shifts.max_by(|a, b| self.gap(*a).total_cmp(&self.gap(*b))).unwrap_or(Vector::Z);
        (-self.gap(normal), self.extremes(normal))
    }

    /// Returns directions of unit length to begin a search with: from centre to centre, and along the axes of both
    /// frames.
    fn directions(&self) -> impl Iterator<Item = Vector> {
        let axes = [Vector::X, Vector::Y, Vector::Z];
        let axes = axes.into_iter().chain(axes.map(|axis| self.pose.rotation * axis));
        let centres = self.pose.translation.try_normalize();
        centres.into_iter().chain(axes).flat_map(|direction| [direction, -direction])
    }

    /// Searches for the nearest points. `None` means that the search has found an overlap, or nothing.
    fn search(&self, direction: Vector, limit: f64) -> Option<Proof> {
        let mut simplex = VoronoiSimplex::new();
        let ConvexPair { first, second, pose } = *self;
        let begin = Some(-direction);
        match closest_points_support_map_support_map_with_params(pose, first, second, limit, &mut simplex, begin) {
            GJKResult::ClosestPoints(on_first, on_second, _) => {
                let normal = (on_second - on_first).try_normalize().unwrap_or(direction);
                Some(Proof { points: [on_first, on_second], gap: self.gap(normal) })
            }
            GJKResult::NoIntersection(normal) | GJKResult::Proximity(normal) => {
                // The library's normals point at the first or the second shape.
                let normal = if self.gap(normal) > self.gap(-normal) { normal } else { -normal };
                Some(Proof { points: self.extremes(normal), gap: self.gap(normal) })
            }
            GJKResult::Intersection => None,
        }
    }

    /// Returns the direction of the shortest shift that separates both, as the library finds it.
    fn penetration(&self, direction: Vector) -> Option<Vector> {
        let mut simplex = VoronoiSimplex::new();
        let ConvexPair { first, second, pose } = *self;
        match contact_support_map_support_map_with_params(pose, first, second, 0.0, &mut simplex, Some(direction)) {
            GJKResult::ClosestPoints(_, _, normal) => normal.try_normalize(),
            _ => None,
        }
    }

    /// Returns the signed distance between two parallel planes with this normal: the first shape ends at one, the second
    /// begins at the other. It is a lower bound of the distance between the shapes.
    fn gap(&self, normal: Vector) -> f64 {
        let [on_first, on_second] = self.extremes(normal);
        normal.dot(on_second - on_first)
    }

    /// Returns the extreme points along a direction: the farthest point of the first shape, and the nearest point of the
    /// second.
    fn extremes(&self, normal: Vector) -> [Vector; 2] {
        [self.first.local_support_point(normal), self.second.support_point(self.pose, -normal)]
    }
}

/// An upper and a lower bound of a distance: a point on each shape, and a gap between the shapes.
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

    /// Moves the second point so that both are as far apart as the gap is wide.
    fn shortened(self) -> Self {
        let [on_first, on_second] = self.points;
        let points = [on_first, on_first + (on_second - on_first) * (self.gap / self.distance())];
        Self { points, ..self }
    }
}
