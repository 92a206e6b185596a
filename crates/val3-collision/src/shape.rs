//! Shapes, and the values that describe no shape.

use parry3d_f64::math::{Pose, Rotation, Vector};
use parry3d_f64::shape::{Cylinder, SharedShape, TriMesh};
use val3_geometry::{IsometryMatrix3, Vector3};

use crate::bounds::Bounds;
use crate::capsules::Capsule;
use crate::convert;

/// Points, and triangles as three indexes of points each.
pub type Triangles = (Vec<Vector3<f64>>, Vec<[u32; 3]>);

/// A shape in its own frame.
#[derive(Clone)]
pub struct Shape {
    pub(crate) form: Form,
    /// Largest distance of a point from the origin of the frame, in mm.
    reach: f64,
}

#[derive(Clone)]
pub(crate) enum Form {
    Capsule(Capsule),
    /// A convex body, and its pose in the frame of the shape.
    Convex(SharedShape, Pose),
    /// Triangles without an inside.
    Surface(SharedShape),
}

/// Reason why values do not describe a shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShapeError {
    /// A length is not a positive number.
    Size,
    /// A coordinate is not a finite number.
    Coordinate,
    /// All points of a hull are in one plane, or are fewer than four.
    Flat,
    /// A surface has no triangle, or a triangle has a point that does not exist.
    Triangles,
}

impl std::fmt::Display for ShapeError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Size => "a length is not greater than 0",
            Self::Coordinate => "a coordinate is not a number",
            Self::Flat => "the points are in one plane and enclose nothing",
            Self::Triangles => "it has no triangle, or a triangle has a point that does not exist",
        })
    }
}

impl std::error::Error for ShapeError {}

impl std::fmt::Debug for Shape {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.form {
            Form::Capsule(capsule) => capsule.fmt(f),
            Form::Convex(shape, _) | Form::Surface(shape) => {
                write!(f, "{:?} {:?}", shape.shape_type(), shape.compute_local_aabb())
            }
        }
    }
}

impl Shape {
    /// Creates a box with its centre in the origin.
    ///
    /// # Errors
    /// [`ShapeError::Size`].
    pub fn cuboid(size: &Vector3<f64>) -> Result<Self, ShapeError> {
        size.iter().try_for_each(|length| positive(*length))?;
        let half = size / 2.0;
        Ok(Self { form: Form::Convex(SharedShape::cuboid(half.x, half.y, half.z), Pose::IDENTITY), reach: half.norm() })
    }

    /// Creates a cylinder around the z axis with its centre in the origin.
    ///
    /// # Errors
    /// [`ShapeError::Size`].
    pub fn cylinder(radius: f64, length: f64) -> Result<Self, ShapeError> {
        positive(radius)?;
        positive(length)?;
        // The library's cylinders are around the y axis. A quarter turn around x turns the y axis to the z axis.
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let turn = Pose::from_rotation(Rotation::from_xyzw(half, 0.0, 0.0, half));
        let shape = SharedShape::new(Cylinder::new(length / 2.0, radius));
        Ok(Self { form: Form::Convex(shape, turn), reach: (length / 2.0 * length / 2.0 + radius * radius).sqrt() })
    }

    /// Creates a sphere around the origin.
    ///
    /// # Errors
    /// [`ShapeError::Size`].
    pub fn sphere(radius: f64) -> Result<Self, ShapeError> {
        Self::capsule(Vector3::zeros(), Vector3::zeros(), radius)
    }

    /// Creates a capsule: all points within a radius of a line segment.
    ///
    /// # Errors
    /// [`ShapeError::Size`] for the radius, [`ShapeError::Coordinate`].
    pub fn capsule(from: Vector3<f64>, to: Vector3<f64>, radius: f64) -> Result<Self, ShapeError> {
        positive(radius)?;
        finite(&[from, to])?;
        let reach = from.norm().max(to.norm()) + radius;
        Ok(Self { form: Form::Capsule(Capsule { from, to, radius }), reach })
    }

    /// Creates the convex hull of points.
    ///
    /// # Errors
    /// [`ShapeError::Coordinate`], [`ShapeError::Flat`].
    pub fn hull(points: &[Vector3<f64>]) -> Result<Self, ShapeError> {
        finite(points)?;
        let corners: Vec<Vector> = points.iter().map(convert::vector).collect();
        let hull = if encloses(points) { SharedShape::convex_hull(&corners) } else { None };
        Ok(Self { form: Form::Convex(hull.ok_or(ShapeError::Flat)?, Pose::IDENTITY), reach: reach(points) })
    }

    /// Creates a surface of triangles, each with the indexes of three `points`.
    ///
    /// # Errors
    /// [`ShapeError::Coordinate`], [`ShapeError::Triangles`].
    pub fn surface(points: &[Vector3<f64>], triangles: &[[u32; 3]]) -> Result<Self, ShapeError> {
        finite(points)?;
        let exists = |number: &u32| usize::try_from(*number).is_ok_and(|number| number < points.len());
        if !triangles.iter().flatten().all(exists) {
            return Err(ShapeError::Triangles);
        }
        let corners = points.iter().map(convert::vector).collect();
        let mesh = TriMesh::new(corners, triangles.to_vec()).map_err(|_| ShapeError::Triangles)?;
        Ok(Self { form: Form::Surface(SharedShape::new(mesh)), reach: reach(points) })
    }

    /// Returns the corners and triangles of a convex hull; `None` for other shapes.
    #[must_use]
    pub fn hull_triangles(&self) -> Option<Triangles> {
        let Form::Convex(shape, _) = &self.form else { return None };
        let (points, triangles) = shape.as_convex_polyhedron()?.to_trimesh();
        Some((points.iter().map(|point| Vector3::new(point.x, point.y, point.z)).collect(), triangles))
    }

    /// Whether the shape is a surface. A surface has no inside: a shape that it encloses does not touch it.
    #[must_use]
    pub fn is_surface(&self) -> bool {
        matches!(self.form, Form::Surface(_))
    }

    /// Radius of the sphere around the frame's origin that contains the shape, in mm.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// Returns the bounding box of the shape at a pose.
    #[must_use]
    pub fn bounds(&self, pose: &IsometryMatrix3<f64>) -> Bounds {
        match &self.form {
            Form::Capsule(capsule) => {
                let Capsule { from, to, radius } = capsule.placed(pose);
                let room = Vector3::repeat(radius);
                Bounds { min: from.inf(&to) - room, max: from.sup(&to) + room }
            }
            Form::Convex(shape, own) => Bounds::of(&shape.compute_aabb(&(convert::pose(pose) * *own))),
            Form::Surface(shape) => Bounds::of(&shape.compute_aabb(&convert::pose(pose))),
        }
    }
}

fn positive(length: f64) -> Result<(), ShapeError> {
    if length.is_finite() && length > 0.0 { Ok(()) } else { Err(ShapeError::Size) }
}

fn finite(points: &[Vector3<f64>]) -> Result<(), ShapeError> {
    let are_numbers = points.iter().flatten().all(|length| length.is_finite());
    if are_numbers { Ok(()) } else { Err(ShapeError::Coordinate) }
}

fn reach(points: &[Vector3<f64>]) -> f64 {
    points.iter().map(Vector3::norm).fold(0.0, f64::max)
}

/// Largest ratio of width or height to extent at which points are in one line or plane.
const FLAT: f64 = 1e-9;

/// Whether points have a volume.
fn encloses(points: &[Vector3<f64>]) -> bool {
    let Some(first) = points.first() else { return false };
    let (extent, second) = farthest(points, |point| (point - first).norm());
    let line = second - first;
    let (width, third) = farthest(points, |point| (point - first).cross(&line).norm() / extent);
    let normal = line.cross(&(third - first));
    let (height, _) = farthest(points, |point| (point - first).dot(&normal).abs() / normal.norm());
    extent > 0.0 && width > FLAT * extent && height > FLAT * extent
}

/// Returns the greatest distance and the first point that has it; 0 and the origin if no distance is positive.
fn farthest(points: &[Vector3<f64>], distance: impl Fn(&Vector3<f64>) -> f64) -> (f64, Vector3<f64>) {
    let mut best = (0.0, Vector3::zeros());
    for point in points {
        let distance = distance(point);
        if distance > best.0 {
            best = (distance, *point);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(shape: Result<Shape, ShapeError>) -> Option<ShapeError> {
        shape.err()
    }

    #[test]
    fn impossible_values_are_no_shape() {
        let size = |x, y, z| Vector3::new(x, y, z);
        assert_eq!(error(Shape::cuboid(&size(1.0, 0.0, 1.0))), Some(ShapeError::Size));
        assert_eq!(error(Shape::sphere(-1.0)), Some(ShapeError::Size));
        assert_eq!(error(Shape::cylinder(1.0, f64::NAN)), Some(ShapeError::Size));
        let infinite = size(f64::INFINITY, 0.0, 0.0);
        assert_eq!(error(Shape::capsule(infinite, infinite, 1.0)), Some(ShapeError::Coordinate));
    }

    #[test]
    fn points_in_one_plane_are_no_hull() {
        let corner = |x: f64, y: f64| Vector3::new(x, y, 2.0 * x - y + 7.0);
        let flat = [corner(0.0, 0.0), corner(1.0, 0.0), corner(0.0, 1.0), corner(3.0, 2.0), corner(1.0, 1.0)];
        for points in [&flat[..], &flat[..2], &[flat[0]; 9], &[]] {
            assert_eq!(error(Shape::hull(points)), Some(ShapeError::Flat), "{points:?}");
        }
        let above = [&flat[..], &[Vector3::new(0.0, 0.0, 9.0)]].concat();
        assert!(Shape::hull(&above).is_ok());
    }

    #[test]
    fn a_surface_has_triangles_of_its_points() {
        let points = [Vector3::zeros(), Vector3::x(), Vector3::y()];
        assert!(Shape::surface(&points, &[[0, 1, 2]]).is_ok());
        assert_eq!(error(Shape::surface(&points, &[[0, 1, 3]])), Some(ShapeError::Triangles));
        assert_eq!(error(Shape::surface(&points, &[])), Some(ShapeError::Triangles));
    }

    #[test]
    fn a_cylinder_is_around_the_z_axis() {
        let bounds = Shape::cylinder(10.0, 100.0).unwrap().bounds(&IsometryMatrix3::identity());
        let half = Vector3::new(10.0, 10.0, 50.0);
        assert!((bounds.max - half).norm() < 1e-9 && (bounds.min + half).norm() < 1e-9, "{bounds:?}");
    }
}
