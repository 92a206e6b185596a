//! Distances from surfaces: a search for the nearest triangle in a tree of bounding boxes.

use parry3d_f64::bounding_volume::Aabb;
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::partitioning::{BvhLeafCost, BvhNode};
use parry3d_f64::shape::{SharedShape, TriMesh};

use crate::convex::{ConvexPair, Found};

/// Returns the nearest points or the overlap of a surface and a shape at a pose, with points in the frame of the
/// surface. The shape may also be a surface.
pub(crate) fn nearest(surface: &TriMesh, shape: &SharedShape, pose: &Pose, limit: f64) -> Found {
    let bounds = shape.compute_aabb(pose);
    let to_box = |node: &BvhNode, _: f64| between(&bounds, node.mins(), node.maxs());
    let to_triangle = |number: u32, limit: f64| {
        let triangle = surface.triangle(number);
        let found = match (shape.as_support_map(), shape.as_trimesh()) {
            (Some(second), _) => ConvexPair { first: &triangle, second, pose }.nearest(limit),
            (None, Some(other)) => {
                let triangle = SharedShape::triangle(triangle.a, triangle.b, triangle.c);
                turned_back(nearest(other, &triangle, &pose.inverse(), limit), pose)
            }
            // Unreachable: every shape is either convex or a surface. An overlap is the safe result, because it hides
            // no contact.
            (None, None) => Found::Overlap,
        };
        Some(NearestTriangle(found))
    };
    // The library ignores a cost that equals the limit.
    let wanted = limit.next_up();
    surface.bvh().find_best(wanted, to_box, to_triangle).map_or(Found::Beyond, |(_, NearestTriangle(found))| found)
}

struct NearestTriangle(Found);

impl BvhLeafCost for NearestTriangle {
    fn cost(&self) -> f64 {
        match self.0 {
            Found::Beyond => f64::MAX,
            Found::Apart([on_surface, on_shape]) => (on_shape - on_surface).length(),
            Found::Overlap => -f64::MAX,
        }
    }
}

fn turned_back(found: Found, pose: &Pose) -> Found {
    let Found::Apart([on_other, on_triangle]) = found else { return found };
    Found::Apart([on_triangle, on_other].map(|point| pose.transform_point(point)))
}

fn between(bounds: &Aabb, mins: Vector, maxs: Vector) -> f64 {
    (mins - bounds.maxs).max(bounds.mins - maxs).max(Vector::ZERO).length()
}
