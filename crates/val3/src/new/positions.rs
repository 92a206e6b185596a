//! Positions of a new application within its arm's reach.

use val3_geometry::Trsf;
use val3_kinematics::{Arm, Configuration, Joints};

use crate::user_error::UserError;

/// Home position of a six-axis arm, in degrees: forearm horizontal, tool downwards.
const HOME: Joints = [0.0, 0.0, 90.0, 0.0, 90.0, 0.0];

/// Position near the point of a six-axis arm, in degrees: to the left of home, tool downwards.
const NEAR: Joints = [20.0, 20.0, 100.0, 0.0, 60.0, 20.0];

/// Home position of a SCARA arm. The stroke is a fraction of its range, from the lower limit.
const SCARA_HOME: Joints = [0.0, 60.0, 0.75, 0.0, 0.0, 0.0];

/// Position near the point of a SCARA arm, in the same form.
const SCARA_NEAR: Joints = [30.0, 60.0, 0.25, 0.0, 0.0, 0.0];

/// Height above the point, as a fraction of the reach and of a SCARA arm's stroke.
const HEIGHT: (f64, f64) = (0.1, 0.4);

/// Positions of the application.
pub(super) struct NewPositions {
    /// Home position, in degrees, or in mm for a stroke.
    pub(super) home: Joints,
    /// Pose of the point in world, in mm and degrees.
    pub(super) point: Trsf,
    /// Configuration of the point.
    pub(super) configuration: Configuration,
    /// Height of the approach above the point, in mm.
    pub(super) height: f64,
}

impl NewPositions {
    /// Computes positions within the reach of the arm.
    ///
    /// # Errors
    /// The limits in the cell do not permit them.
    pub(super) fn of(arm: &Arm) -> Result<Self, UserError> {
        let (home, near) = if arm.is_scara() { (SCARA_HOME, SCARA_NEAR) } else { (HOME, NEAR) };
        let (home, near) = (joints(arm, home), joints(arm, near));
        let height = (arm.reach() * HEIGHT.0).min(stroke(arm) * HEIGHT.1);
        let positions = Self {
            home,
            point: rounded(&arm.forward(&near)),
            configuration: arm.configuration(&near),
            height: height.floor(),
        };
        if positions.is_reached(arm, &near) {
            return Ok(positions);
        }
        Err(UserError::new(format!("the limits of the cell exclude the usual positions of the {}", arm.name()))
            .with_help(
                "correct the limits in arm.cfx and cell.cfx, or name a folder outside of the cell: --folder DIR",
            ))
    }

    /// Whether the arm reaches home, the point, and the path above the point.
    fn is_reached(&self, arm: &Arm, near: &Joints) -> bool {
        let mut path = (0..=10).map(|step| self.above(f64::from(step) / 10.0));
        let is_path_reached = path.all(|pose| {
            let joints = arm.inverse_on(self.configuration, &pose, near);
            joints.is_ok_and(|joints| arm.is_in_range(&joints))
        });
        arm.is_in_range(&self.home) && is_path_reached
    }

    /// Pose above the point, at this part of the height (0 to 1).
    fn above(&self, part: f64) -> Trsf {
        Trsf { z: self.height.mul_add(part, self.point.z), ..self.point }
    }
}

/// Converts values with a relative stroke to joints of the arm.
fn joints(arm: &Arm, mut joints: Joints) -> Joints {
    let limits = arm.limits();
    for (axis, (joint, limits)) in joints.iter_mut().zip(limits).enumerate() {
        if arm.is_stroke(axis) {
            *joint = (limits.max - limits.min).mul_add(*joint, limits.min).round();
        }
        *joint = joint.clamp(limits.min, limits.max);
    }
    joints
}

/// Length of the stroke, in mm; infinite for an arm without a stroke.
fn stroke(arm: &Arm) -> f64 {
    let axes = arm.limits().iter().enumerate();
    let mut strokes = axes.filter(|(axis, _)| arm.is_stroke(*axis)).map(|(_, limits)| limits.max - limits.min);
    strokes.next().unwrap_or(f64::INFINITY)
}

/// Rounds the pose to whole mm and degrees, like taught values in examples.
fn rounded(pose: &Trsf) -> Trsf {
    let whole = |value: f64| value.round() + 0.0;
    let Trsf { x, y, z, rx, ry, rz } = pose;
    Trsf::new([whole(*x), whole(*y), whole(*z)], [whole(*rx), whole(*ry), whole(*rz)])
}
