//! The circle through three positions.

use nalgebra::Vector3;

use crate::ArcError;

/// Two positions nearer than this, in mm, are one.
const SAME_PLACE: f64 = 1e-3;

/// Three positions whose legs enclose an angle of less than this sine are on one line.
const COLLINEAR: f64 = 1e-6;

/// A circle in space, run through from its first point.
///
/// It is described from that point and not from the centre, which is far away where the points are nearly on one line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Circle {
    pub(crate) first: Vector3<f64>,
    /// From the centre to the first point.
    pub(crate) radius: Vector3<f64>,
    /// As long as the radius, in the direction of travel at the first point.
    tangent: Vector3<f64>,
}

impl Circle {
    /// The circle that comes from `first` through `second` to `third`.
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

    /// How far on a point of the circle is, in ]0, 2π[ radians: twice the angle of its chord with the tangent.
    pub(crate) fn angle_to(&self, point: &Vector3<f64>) -> f64 {
        let chord = point - self.first;
        2.0 * libm::atan2(-chord.dot(&self.radius), chord.dot(&self.tangent))
    }

    /// The point after an angle in radians.
    pub(crate) fn at(&self, angle: f64) -> Vector3<f64> {
        let (sin, cos) = libm::sincos(angle / 2.0);
        self.first + (self.tangent * cos - self.radius * sin) * (2.0 * sin)
    }
}
