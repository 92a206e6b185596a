//! Random points, poses and shapes for tests.

use proptest::prelude::*;
use val3_geometry::{IsometryMatrix3, Trsf, Vector3};

use crate::Shape;

/// Points with coordinates between `-most` and `most`.
pub(crate) fn point(most: f64) -> impl Strategy<Value = Vector3<f64>> {
    [-most..most, -most..most, -most..most].prop_map(Vector3::from)
}

/// Poses within 500 mm of the origin.
pub(crate) fn pose() -> impl Strategy<Value = IsometryMatrix3<f64>> {
    let angle = || -180.0..180.0;
    ([-500.0..500.0, -500.0..500.0, -500.0..500.0], [angle(), angle(), angle()])
        .prop_map(|(place, angles)| Trsf::new(place, angles).isometry())
}

/// Convex shapes of all kinds, with sizes from 5 to 600 mm.
pub(crate) fn convex() -> impl Strategy<Value = Shape> {
    let length = || 5.0..300.0;
    prop_oneof![
        [length(), length(), length()].prop_map(|size| Shape::cuboid(&Vector3::from(size)).unwrap()),
        (length(), length()).prop_map(|(radius, length)| Shape::cylinder(radius, length).unwrap()),
        length().prop_map(|radius| Shape::sphere(radius).unwrap()),
        (point(200.0), point(200.0), length()).prop_map(|(from, to, radius)| Shape::capsule(from, to, radius).unwrap()),
        hull(),
    ]
}

/// Convex hulls of a few random points.
pub(crate) fn hull() -> impl Strategy<Value = Shape> {
    corners().prop_map(|points| Shape::hull(&points).unwrap())
}

/// A few random points with a volume.
pub(crate) fn corners() -> impl Strategy<Value = Vec<Vector3<f64>>> {
    prop::collection::vec(point(150.0), 4..12).prop_filter("flat", |points| Shape::hull(points).is_ok())
}

/// Returns the surface of the convex hull: the triangles that have all points on one side.
pub(crate) fn outside(points: &[Vector3<f64>]) -> Shape {
    let numbers = 0..u32::try_from(points.len()).unwrap();
    let corner = |number: u32| points[usize::try_from(number).unwrap()];
    let mut triangles = Vec::new();
    for a in numbers.clone() {
        for b in numbers.clone() {
            for c in numbers.clone().filter(|c| a < b && b < *c) {
                let normal = (corner(b) - corner(a)).cross(&(corner(c) - corner(a)));
                let sides: Vec<f64> = points.iter().map(|point| (point - corner(a)).dot(&normal)).collect();
                if sides.iter().all(|side| *side < 1e-6) || sides.iter().all(|side| *side > -1e-6) {
                    triangles.push([a, b, c]);
                }
            }
        }
    }
    Shape::surface(points, &triangles).unwrap()
}
