//! Flange velocity per axis velocity.

use val3_geometry::Vector3;

use crate::{Arm, Joints};

/// Flange velocity in world when one axis moves at one unit per second.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twist {
    /// Linear velocity: mm per degree, or mm per mm for a stroke.
    pub linear: Vector3<f64>,
    /// Angular velocity in degrees per degree: the unit vector of the axis, or zero for a stroke.
    pub angular: Vector3<f64>,
}

impl Arm {
    /// Computes the geometric Jacobian at the centre of the flange, with one column per axis. The columns of missing
    /// axes are zero.
    #[must_use]
    pub fn jacobian(&self, joints: &Joints) -> [Twist; 6] {
        let links = self.links(joints);
        let flange = links.last().map(|link| link.translation.vector).unwrap_or_default();
        let mut columns = [Twist::default(); 6];
        for (axis, (column, base)) in columns.iter_mut().zip(&links).take(self.axes()).enumerate() {
            let z = base.rotation.matrix().column(2).into_owned();
            *column = if self.is_stroke(axis) {
                Twist { linear: z, angular: Vector3::zeros() }
            } else {
                let arm = flange - base.translation.vector;
                Twist { linear: z.cross(&arm) * 1.0_f64.to_radians(), angular: z }
            };
        }
        columns
    }
}
