//! Distances from surfaces: a search for the nearest triangle in a tree of bounding boxes.

use parry3d_f64::bounding_volume::Aabb;
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::partitioning::{BvhLeafCost, BvhNode};
use parry3d_f64::shape::{Segment, SharedShape, SupportMap, TriMesh, Triangle};

use crate::convert;
use crate::convex::{ConvexPair, Found};
use crate::segments::LineSegment;

/// Returns the nearest points or the overlap of a surface and a shape at a pose, with points in the frame of the
/// surface. The shape may also be a surface.
pub(crate) fn nearest(surface: &TriMesh, shape: &SharedShape, pose: &Pose, limit: f64) -> Found {
    if let Some(Segment { a, b }) = shape.as_segment() {
        let [from, to] = [*a, *b].map(|end| convert::back(pose.transform_point(end)));
        return nearest_of_segment(surface, &LineSegment { from, to }, limit);
    }
    let bounds = shape.compute_aabb(pose);
    match (shape.as_support_map(), shape.as_trimesh()) {
        (Some(shape), _) => nearest_of_convex(surface, &ConvexShape { shape, pose, bounds }, limit),
        (None, Some(other)) => {
            let to_box = |node: &BvhNode, _: f64| between(&bounds, node.mins(), node.maxs());
            let to_triangle = |number: u32, limit: f64| {
                let Triangle { a, b, c } = surface.triangle(number);
                let found = nearest(other, &SharedShape::triangle(a, b, c), &pose.inverse(), limit);
                Some(NearestTriangle(turned_back(found, pose)))
            };
            search(surface, to_box, to_triangle, limit)
        }
        // Unreachable: every shape is either convex or a surface. An overlap is the safe result, because it hides no
        // contact.
        (None, None) => Found::Overlap,
    }
}

/// A convex shape at a pose.
struct ConvexShape<'s> {
    shape: &'s dyn SupportMap,
    pose: &'s Pose,
    bounds: Aabb,
}

impl ConvexShape<'_> {
    /// Lower bound of the distance from a convex shape around `centre`, whose extreme coordinate in a direction is
    /// `least`: the gap between two planes perpendicular to the line through both centres.
    fn gap(&self, centre: Vector, least: impl Fn(Vector) -> f64) -> f64 {
        let Some(direction) = (centre - self.bounds.center()).try_normalize() else { return 0.0 };
        least(direction) - self.shape.support_point(self.pose, direction).dot(direction)
    }
}

/// Returns the nearest points or the overlap of a surface and a convex shape in the frame of the surface.
fn nearest_of_convex(surface: &TriMesh, convex: &ConvexShape<'_>, limit: f64) -> Found {
    // Many triangles can be within the box around a shape that is not a box itself.
    let to_box = |node: &BvhNode, limit: f64| {
        let (mins, maxs, centre) = (node.mins(), node.maxs(), node.center());
        let bound = between(&convex.bounds, mins, maxs);
        if bound > limit {
            return bound;
        }
        let extent = (maxs - mins) / 2.0;
        bound.max(convex.gap(centre, |direction| centre.dot(direction) - extent.dot(direction.abs())))
    };
    let to_triangle = |number: u32, limit: f64| {
        let triangle = surface.triangle(number);
        let corners = [triangle.a, triangle.b, triangle.c];
        let centre = (triangle.a + triangle.b + triangle.c) / 3.0;
        let gap = convex
            .gap(centre, |direction| corners.iter().map(|corner| corner.dot(direction)).fold(f64::INFINITY, f64::min));
        if gap > limit {
            return Some(NearestTriangle(Found::Beyond));
        }
        let (towards, ConvexShape { shape: second, pose, .. }) = (convex.bounds.center() - centre, convex);
        Some(NearestTriangle(ConvexPair { first: &triangle, second: *second, pose, towards }.nearest(limit)))
    };
    search(surface, to_box, to_triangle, limit)
}

/// Returns the nearest points or the overlap of a surface and a line segment in the frame of the surface.
fn nearest_of_segment(surface: &TriMesh, segment: &LineSegment, limit: f64) -> Found {
    let ends = [segment.from, segment.to].map(|end| convert::vector(&end));
    let bounds = Aabb::from_points(ends);
    // The box around a long segment is large. The distance from the sphere around the node's box is then the better
    // lower bound.
    let to_box = |node: &BvhNode, _: f64| {
        let (centre, radius) = (convert::back(node.center()), (node.maxs() - node.mins()).length() / 2.0);
        between(&bounds, node.mins(), node.maxs()).max(segment.distance_to(&centre) - radius)
    };
    let to_triangle = |number: u32, limit: f64| {
        let Triangle { a, b, c } = surface.triangle(number);
        let points = segment.nearest_of_triangle(&[a, b, c].map(convert::back));
        Some(NearestTriangle(match points {
            None => Found::Overlap,
            Some([on_segment, on_surface]) if (on_surface - on_segment).norm() <= limit => {
                Found::Apart([on_surface, on_segment].map(|point| convert::vector(&point)))
            }
            Some(_) => Found::Beyond,
        }))
    };
    search(surface, to_box, to_triangle, limit)
}

/// Searches the nearest triangle, with lower bounds of the distances from the boxes of nodes.
fn search(
    surface: &TriMesh,
    to_box: impl Fn(&BvhNode, f64) -> f64,
    to_triangle: impl Fn(u32, f64) -> Option<NearestTriangle>,
    limit: f64,
) -> Found {
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
