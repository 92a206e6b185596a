//! Distance or overlap between two shapes.

use parry3d_f64::math::Pose;
use parry3d_f64::shape::SharedShape;
use val3_geometry::{IsometryMatrix3, Vector3};

use crate::capsules::Capsule;
use crate::convert;
use crate::convex::{ConvexPair, Found};
use crate::shape::{Form, Shape};
use crate::surfaces;

/// A shape at a pose in the common frame.
#[derive(Debug, Clone, Copy)]
pub struct PlacedShape<'s> {
    /// The shape.
    pub shape: &'s Shape,
    /// Pose of the shape's frame in the common frame.
    pub pose: &'s IsometryMatrix3<f64>,
}

/// Distance or overlap between two shapes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Nearness {
    /// The distance is greater than the limit of the query.
    Beyond,
    /// The shapes are apart.
    Apart(Closest),
    /// The shapes overlap.
    Overlap(Overlap),
}

/// The shortest connection between two shapes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closest {
    /// Distance in mm.
    pub distance: f64,
    /// A nearest point on the first and on the second shape, in the common frame.
    pub points: [Vector3<f64>; 2],
}

/// Depth and location of an overlap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// Length in mm of the shortest shift that separates the shapes; `None` for surfaces, which have no inside.
    pub depth: Option<f64>,
    /// A common point, in the common frame.
    pub at: Vector3<f64>,
}

/// Returns the distance or overlap between two shapes. Pairs beyond `limit` (in mm) are detected quickly: for surfaces
/// with many triangles, a query with a limit of 10 mm is a hundred times as fast as without a limit.
#[must_use]
pub fn nearest(a: PlacedShape<'_>, b: PlacedShape<'_>, limit: f64) -> Nearness {
    if let (Form::Capsule(first), Form::Capsule(second)) = (&a.shape.form, &b.shape.form) {
        let cores = first.placed(a.pose).nearest(&second.placed(b.pose));
        return rounded(cores, [first.radius, second.radius], true, limit);
    }
    let (first, second) = (Core::of(a), Core::of(b));
    let reach = limit + first.radius + second.radius;
    let relative = first.pose.inv_mul(&second.pose);
    match between(&first, &second, &relative, reach) {
        Found::Beyond => Nearness::Beyond,
        Found::Apart(points) => {
            let cores = points.map(|point| convert::back(first.pose.transform_point(point)));
            rounded(cores, [first.radius, second.radius], are_solid(a, b), limit)
        }
        Found::Overlap => Nearness::Overlap(overlap(a, b)),
    }
}

/// A shape without its rounding: the axis of a capsule, or any other shape unchanged. The library computes distances
/// from axes exactly, but distances from round bodies only approximately.
struct Core {
    shape: SharedShape,
    pose: Pose,
    /// Distance in mm between the core and the shape's surface.
    radius: f64,
}

impl Core {
    fn of(placed: PlacedShape<'_>) -> Self {
        let pose = convert::pose(placed.pose);
        match &placed.shape.form {
            Form::Capsule(Capsule { from, to, radius }) => {
                Self { shape: SharedShape::segment(convert::vector(from), convert::vector(to)), pose, radius: *radius }
            }
            Form::Convex(shape, own) => Self { shape: shape.clone(), pose: pose * *own, radius: 0.0 },
            Form::Surface(shape) => Self { shape: shape.clone(), pose, radius: 0.0 },
        }
    }

    /// Returns the entire shape at its pose, as a core without rounding.
    fn whole(placed: PlacedShape<'_>) -> Self {
        let core = Self::of(placed);
        match &placed.shape.form {
            Form::Capsule(Capsule { from, to, radius }) => {
                let shape = SharedShape::capsule(convert::vector(from), convert::vector(to), *radius);
                Self { shape, radius: 0.0, ..core }
            }
            Form::Convex(..) | Form::Surface(_) => core,
        }
    }
}

fn are_solid(a: PlacedShape<'_>, b: PlacedShape<'_>) -> bool {
    !a.shape.is_surface() && !b.shape.is_surface()
}

/// Returns the nearest points or the overlap of the cores, with points in the first core's frame. `relative` is the
/// second core's pose in this frame.
fn between(first: &Core, second: &Core, relative: &Pose, limit: f64) -> Found {
    if let Some(surface) = first.shape.as_trimesh() {
        return surfaces::nearest(surface, &second.shape, relative, limit);
    }
    if let Some(surface) = second.shape.as_trimesh() {
        let found = surfaces::nearest(surface, &first.shape, &relative.inverse(), limit);
        let Found::Apart([on_second, on_first]) = found else { return found };
        return Found::Apart([on_first, on_second].map(|point| relative.transform_point(point)));
    }
    match (first.shape.as_support_map(), second.shape.as_support_map()) {
        (Some(first), Some(second)) => {
            ConvexPair { first, second, pose: relative, towards: relative.translation }.nearest(limit)
        }
        // Unreachable: only surfaces are not convex. An overlap is the safe result, because it hides no contact.
        _ => Found::Overlap,
    }
}

/// Returns the distance or overlap between shapes whose cores have these nearest points.
fn rounded(cores: [Vector3<f64>; 2], radii: [f64; 2], are_solid: bool, limit: f64) -> Nearness {
    let between = cores[1] - cores[0];
    let length = between.norm();
    let distance = length - radii[0] - radii[1];
    // Cores that touch have no direction between them, so any direction is valid.
    let direction = if length > 0.0 { between / length } else { Vector3::z() };
    let points = [cores[0] + direction * radii[0], cores[1] - direction * radii[1]];
    if distance > limit {
        Nearness::Beyond
    } else if distance > 0.0 {
        Nearness::Apart(Closest { distance, points })
    } else {
        Nearness::Overlap(Overlap { depth: are_solid.then_some(-distance), at: (points[0] + points[1]) / 2.0 })
    }
}

/// Returns the depth and a common point of shapes whose cores overlap or touch.
fn overlap(a: PlacedShape<'_>, b: PlacedShape<'_>) -> Overlap {
    let (first, second) = (Core::whole(a), Core::whole(b));
    match (first.shape.as_support_map(), second.shape.as_support_map()) {
        (Some(on), Some(other)) => {
            let relative = first.pose.inv_mul(&second.pose);
            let pair = ConvexPair { first: on, second: other, pose: &relative, towards: relative.translation };
            let (depth, points) = pair.overlap();
            let at = first.pose.transform_point((points[0] + points[1]) / 2.0);
            Overlap { depth: Some(depth.max(0.0)), at: convert::back(at) }
        }
        _ => Overlap { depth: None, at: a.shape.bounds(a.pose).between(&b.shape.bounds(b.pose)) },
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::testing::{convex, corners, hull, outside, pose};

    /// Returns the distance of disjoint shapes, and the negative depth of overlapping shapes.
    fn signed(nearness: Nearness) -> f64 {
        match nearness {
            Nearness::Beyond => f64::INFINITY,
            Nearness::Apart(closest) => closest.distance,
            Nearness::Overlap(overlap) => -overlap.depth.unwrap(),
        }
    }

    fn between(a: &Shape, at_a: &IsometryMatrix3<f64>, b: &Shape, at_b: &IsometryMatrix3<f64>) -> Nearness {
        nearest(PlacedShape { shape: a, pose: at_a }, PlacedShape { shape: b, pose: at_b }, 5000.0)
    }

    fn translated(to: Vector3<f64>) -> IsometryMatrix3<f64> {
        IsometryMatrix3::translation(to.x, to.y, to.z)
    }

    proptest! {
        #[test]
        fn the_order_of_both_does_not_matter(a in convex(), at_a in pose(), b in convex(), at_b in pose()) {
            let (there, back) = (between(&a, &at_a, &b, &at_b), between(&b, &at_b, &a, &at_a));
            prop_assert!((signed(there) - signed(back)).abs() < 1e-3, "{there:?} {back:?}");
        }

        #[test]
        fn a_common_pose_changes_nothing(a in convex(), at_a in pose(), b in convex(), at_b in pose(), moved in pose()) {
            let (here, there) = (between(&a, &at_a, &b, &at_b), between(&a, &(moved * at_a), &b, &(moved * at_b)));
            prop_assert!((signed(here) - signed(there)).abs() < 1e-3, "{here:?} {there:?}");
        }

        /// The distance of bounding boxes is at most the distance of the shapes, and all points are within the reach.
        #[test]
        fn bounds_are_nearer_than_shapes(a in convex(), at_a in pose(), b in convex(), at_b in pose()) {
            let distance = a.bounds(&at_a).distance(&b.bounds(&at_b));
            prop_assert!(distance <= signed(between(&a, &at_a, &b, &at_b)).max(0.0) + 1e-6);
            let origins = (at_a.translation.vector - at_b.translation.vector).norm();
            let least = origins - a.reach() - b.reach();
            prop_assert!(signed(between(&a, &at_a, &b, &at_b)) >= least - 1e-6);
        }

        /// The nearest points belong to both shapes: a small sphere around each point touches its own shape, and has
        /// the reported distance from the other shape.
        #[test]
        fn nearest_points_are_on_the_shapes(a in hull(), at_a in pose(), b in convex(), at_b in pose()) {
            let Nearness::Apart(Closest { distance, points }) = between(&a, &at_a, &b, &at_b) else { return Ok(()) };
            let dot = Shape::sphere(1e-3).unwrap();
            let off = signed(between(&dot, &translated(points[0]), &a, &at_a));
            prop_assert!(off < 2e-3, "{off} mm from its shape");
            prop_assert!(signed(between(&dot, &translated(points[1]), &b, &at_b)) < 2e-3);
            prop_assert!(signed(between(&dot, &translated(points[0]), &b, &at_b)) > distance - 2e-3);
        }
    }
    proptest! {
        /// Boxes on a grid often touch with whole faces, edges or corners.
        #[test]
        fn boxes_on_a_grid_are_apart_by_their_coordinates(
            sizes in [[1..4_i32, 1..4, 1..4], [1..4_i32, 1..4, 1..4]],
            offset in [-4..5_i32, -4..5, -4..5],
            turned in pose(),
        ) {
            let [a, b] = sizes.map(|size| Shape::cuboid(&Vector3::from(size.map(|length| f64::from(length * 100)))).unwrap());
            let offset = offset.map(|length| f64::from(length * 50));
            // Along each axis: the distance of the faces, negative where they overlap.
            let gaps: Vec<f64> = (0..3)
                .map(|axis| offset[axis].abs() - f64::from(sizes[0][axis] + sizes[1][axis]) * 50.0)
                .collect();
            let deepest = gaps.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let apart = gaps.iter().map(|gap| gap.max(0.0).powi(2)).sum::<f64>().sqrt();
            let expected = if deepest < 0.0 { deepest } else { apart };
            let aside = IsometryMatrix3::translation(offset[0], offset[1], offset[2]);
            for place in [IsometryMatrix3::identity(), turned] {
                let found = signed(between(&a, &place, &b, &(place * aside)));
                prop_assert!((found - expected).abs() < 1e-3, "{found} instead of {expected}");
            }
        }

        /// A limit does not change the distance of pairs within the limit.
        #[test]
        fn a_limit_changes_no_distance(a in convex(), at_a in pose(), b in convex(), at_b in pose(), limit in 0.0..900.0) {
            let [a, b] = [PlacedShape { shape: &a, pose: &at_a }, PlacedShape { shape: &b, pose: &at_b }];
            let (all, near) = (signed(nearest(a, b, 5000.0)), signed(nearest(a, b, limit)));
            if near.is_infinite() {
                prop_assert!(all > limit - 1e-3, "{all} is beyond {limit}");
            } else {
                prop_assert!((all - near).abs() < 1e-3 && near <= limit, "{all} {near}");
            }
        }

        /// The surface of a hull has the same distance from a shape as the hull itself, unless the shape is inside.
        #[test]
        fn the_surface_of_a_hull_is_as_far_as_the_hull(points in corners(), at in pose(), b in convex(), at_b in pose()) {
            let (hull, surface) = (Shape::hull(&points).unwrap(), outside(&points));
            match between(&hull, &at, &b, &at_b) {
                Nearness::Apart(there) => {
                    let found = between(&surface, &at, &b, &at_b);
                    let Nearness::Apart(closest) = found else { panic!("{found:?} instead of {there:?}") };
                    prop_assert!((closest.distance - there.distance).abs() < 1e-3, "{closest:?} {there:?}");
                    let mirrored = between(&b, &at_b, &surface, &at);
                    let Nearness::Apart(mirrored) = mirrored else { panic!("{mirrored:?} instead of {there:?}") };
                    let dot = Shape::sphere(1e-3).unwrap();
                    let on_b = translated(mirrored.points[0]);
                    prop_assert!(signed(between(&dot, &on_b, &b, &at_b)) < 2e-3);
                    let both = between(&surface, &at, &surface, &(at_b * IsometryMatrix3::translation(3000.0, 0.0, 0.0)));
                    prop_assert!(matches!(both, Nearness::Apart(_)), "{both:?}");
                }
                Nearness::Overlap(_) | Nearness::Beyond => {}
            }
        }
    }
}
