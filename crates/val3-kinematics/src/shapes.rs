//! Approximate shape of an arm: capsules (cylinders with rounded ends) around its links.

use val3_geometry::Vector3;

/// A capsule: the points within a radius of a line, in mm, in the frame of a body.
///
/// The frames of the base and of the links are the results of [`crate::Arm::parts`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkCapsule {
    /// One end of the line.
    pub from: Vector3<f64>,
    /// The other end; the same point for a sphere.
    pub to: Vector3<f64>,
    /// Radius, greater than 0.
    pub radius: f64,
}
