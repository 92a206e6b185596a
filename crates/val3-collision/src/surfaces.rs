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
        return search(surface, &OtherSegment::new([*a, *b].map(|end| pose.transform_point(end))), limit);
    }
    let bounds = shape.compute_aabb(pose);
    match (shape.as_support_map(), shape.as_trimesh()) {
        (Some(shape), _) => search(surface, &OtherConvex { shape, pose, bounds }, limit),
        (None, Some(other)) => search(surface, &OtherSurface { surface: other, pose, bounds }, limit),
        // Unreachable: every shape is either convex or a surface. An overlap is the safe result, because it hides no
        // contact.
        (None, None) => Found::Overlap,
    }
}

/// Searches the surface for the triangle that is nearest to the other shape.
fn search(surface: &TriMesh, other: &impl OtherShape, limit: f64) -> Found {
    // The library ignores a cost that equals the limit.
    let limit = limit.next_up();
    let nearest = surface.bvh().find_best(
        limit,
        |node, limit| other.least_distance(node, limit),
        |number, limit| Some(NearestTriangle(other.nearest_of_triangle(&surface.triangle(number), limit))),
    );
    nearest.map_or(Found::Beyond, |(_, NearestTriangle(found))| found)
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

/// The shape whose distance from a surface is searched, in the frame of the surface.
trait OtherShape {
    /// Returns a lower bound of the distance to a node's box. The bound may be coarse if it is greater than the limit.
    fn least_distance(&self, node: &BvhNode, limit: f64) -> f64;

    /// Returns the nearest points or the overlap of a triangle and the shape. The first point is on the triangle.
    fn nearest_of_triangle(&self, triangle: &Triangle, limit: f64) -> Found;
}

struct OtherSegment {
    segment: LineSegment,
    bounds: Aabb,
}

impl OtherSegment {
    fn new(ends: [Vector; 2]) -> Self {
        let [from, to] = ends.map(convert::back);
        Self { segment: LineSegment { from, to }, bounds: Aabb::from_points(ends) }
    }
}

impl OtherShape for OtherSegment {
    /// The box around a long diagonal segment contains much empty space, so the distance from the segment to the sphere
    /// around the node's box may be the better bound.
    fn least_distance(&self, node: &BvhNode, _: f64) -> f64 {
        let (centre, radius) = (convert::back(node.center()), (node.maxs() - node.mins()).length() / 2.0);
        between(&self.bounds, node.mins(), node.maxs()).max(self.segment.distance_to(&centre) - radius)
    }

    fn nearest_of_triangle(&self, triangle: &Triangle, limit: f64) -> Found {
        let Triangle { a, b, c } = *triangle;
        match self.segment.nearest_of_triangle(&[a, b, c].map(convert::back)) {
            None => Found::Overlap,
            Some([on_segment, on_surface]) if (on_surface - on_segment).norm() <= limit => {
                Found::Apart([on_surface, on_segment].map(|point| convert::vector(&point)))
            }
            Some(_) => Found::Beyond,
        }
    }
}

struct OtherConvex<'s> {
    shape: &'s dyn SupportMap,
    pose: &'s Pose,
    bounds: Aabb,
}

impl OtherConvex<'_> {
    /// Returns a lower bound of the distance to a convex body around `centre`, whose smallest coordinate along a
    /// direction is `least`: the gap between two planes perpendicular to the line through both centres.
    fn gap(&self, centre: Vector, least: impl Fn(Vector) -> f64) -> f64 {
        let Some(direction) = (centre - self.bounds.center()).try_normalize() else { return 0.0 };
        least(direction) - self.shape.support_point(self.pose, direction).dot(direction)
    }
}

impl OtherShape for OtherConvex<'_> {
    /// Boxes within the limit are also compared by their gap, because the box around a shape may contain many triangles
    /// that are far from the shape.
    fn least_distance(&self, node: &BvhNode, limit: f64) -> f64 {
        let (mins, maxs, centre) = (node.mins(), node.maxs(), node.center());
        let bound = between(&self.bounds, mins, maxs);
        if bound > limit {
            return bound;
        }
        let extent = (maxs - mins) / 2.0;
        bound.max(self.gap(centre, |direction| centre.dot(direction) - extent.dot(direction.abs())))
    }

    fn nearest_of_triangle(&self, triangle: &Triangle, limit: f64) -> Found {
        let corners = [triangle.a, triangle.b, triangle.c];
        let centre = (triangle.a + triangle.b + triangle.c) / 3.0;
        let gap = self
            .gap(centre, |direction| corners.iter().map(|corner| corner.dot(direction)).fold(f64::INFINITY, f64::min));
        if gap > limit {
            return Found::Beyond;
        }
        let towards = self.bounds.center() - centre;
        ConvexPair { first: triangle, second: self.shape, pose: self.pose, towards }.nearest(limit)
    }
}

struct OtherSurface<'s> {
    surface: &'s TriMesh,
    pose: &'s Pose,
    bounds: Aabb,
}

impl OtherShape for OtherSurface<'_> {
    fn least_distance(&self, node: &BvhNode, _: f64) -> f64 {
        between(&self.bounds, node.mins(), node.maxs())
    }

    fn nearest_of_triangle(&self, triangle: &Triangle, limit: f64) -> Found {
        let Triangle { a, b, c } = *triangle;
        match nearest(self.surface, &SharedShape::triangle(a, b, c), &self.pose.inverse(), limit) {
            Found::Apart([on_other, on_triangle]) => {
                Found::Apart([on_triangle, on_other].map(|point| self.pose.transform_point(point)))
            }
            found => found,
        }
    }
}

/// Returns the distance from a box to the box with these extreme corners; 0 if they overlap.
fn between(bounds: &Aabb, mins: Vector, maxs: Vector) -> f64 {
    (mins - bounds.maxs).max(bounds.mins - maxs).max(Vector::ZERO).length()
}
