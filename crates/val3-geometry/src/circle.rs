//! Circle through three positions.

use nalgebra::Vector3;

use crate::ArcError;

/// Distance below which two positions are the same, in mm.
const SAME_PLACE: f64 = 1e-3;

/// Sine of the angle between the legs below which three positions are collinear.
const COLLINEAR: f64 = 1e-6;

/// A circle in space, traversed from its first point.
///
/// It is described relative to this point and not to the centre, which is far away if the points are nearly collinear.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Circle {
    pub(crate) first: Vector3<f64>,
    /// From the centre to the first point.
    pub(crate) radius: Vector3<f64>,
    /// Tangent in the direction of travel at the first point, with the length of the radius.
    tangent: Vector3<f64>,
}

impl Circle {
    /// Creates the circle from `first` through `second` to `third`.
    pub(crate) fn through(first: &Vector3<f64>, second: &Vector3<f64>, third: &Vector3<f64>) -> Result<Self, ArcError> {
        let (a, b) = (second - first, third - first);
        let (near, far, between) = (a.norm(), b.norm(), (third - second).norm());
        if near.min(far).min(between) < SAME_PLACE {
            return Err(ArcError::TooClose);
        }
        let normal = a.cross(&b);
        if normal.norm() < COLLINEAR * near * between {
            return Err(ArcError::Collinear);
        }
        let radius = (a * (far * far) - b * (near * near)).cross(&normal) / (2.0 * normal.norm_squared());
        Ok(Self { first: *first, radius, tangent: normal.normalize().cross(&radius) })
    }

    /// Returns the angle from the first point to a point on the circle, in ]0, 2π[ radians: twice the angle between
    /// chord and tangent.
    pub(crate) fn angle_to(&self, point: &Vector3<f64>) -> f64 {
        let chord = point - self.first;
        2.0 * libm::atan2(-chord.dot(&self.radius), chord.dot(&self.tangent))
    }

    /// Returns the point at an angle in radians.
    pub(crate) fn at(&self, angle: f64) -> Vector3<f64> {
        let (sin, cos) = libm::sincos(angle / 2.0);
        self.first + (self.tangent * cos - self.radius * sin) * (2.0 * sin)
    }
}
