//! Distances between capsules in closed form: the distance between two line segments, minus both radii.

use val3_geometry::{IsometryMatrix3, Vector3};

use crate::segments::LineSegment;

/// The points within a radius of a line segment. A sphere has a segment of length 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Capsule {
    pub(crate) from: Vector3<f64>,
    pub(crate) to: Vector3<f64>,
    pub(crate) radius: f64,
}

impl Capsule {
    pub(crate) fn placed(&self, pose: &IsometryMatrix3<f64>) -> Self {
        let place = |point: &Vector3<f64>| pose.rotation * point + pose.translation.vector;
        Self { from: place(&self.from), to: place(&self.to), radius: self.radius }
    }

    /// Returns the nearest points of both axes.
    pub(crate) fn nearest(&self, other: &Self) -> [Vector3<f64>; 2] {
        self.axis().nearest(&other.axis())
    }

    const fn axis(&self) -> LineSegment {
        LineSegment { from: self.from, to: self.to }
    }
}
