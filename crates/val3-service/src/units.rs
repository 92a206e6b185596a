//! Units of the interface: m and rad, where the controller has mm and degrees.

use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::{Arm, Joints};
use val3_soap::v0::CartesianPosition;

/// Millimetres in a metre.
pub(crate) const MM: f64 = 1000.0;

/// Converts joints to rad, and to m for a stroke.
pub(crate) fn joints_to_si(joints: &[f64], arm: &Arm) -> Vec<f64> {
    let convert = |(axis, value): (usize, &f64)| if arm.is_stroke(axis) { value / MM } else { value.to_radians() };
    joints.iter().take(arm.axes()).enumerate().map(convert).collect()
}

/// Converts joints from rad, and from m for a stroke. `None` if the number of joints is wrong.
pub(crate) fn joints_from_si(joints: &[f64], arm: &Arm) -> Option<Joints> {
    if joints.len() != arm.axes() {
        return None;
    }
    let joint = |axis| joints.get(axis).copied().unwrap_or_default();
    Some(std::array::from_fn(|axis| joint_from_si(joint(axis), arm.is_stroke(axis))))
}

/// Converts the joint of an axis from rad to degrees, or from m to mm if it is a stroke.
fn joint_from_si(value: f64, is_stroke: bool) -> f64 {
    if is_stroke { value * MM } else { value.to_degrees() }
}

/// Converts a pose in mm.
pub(crate) fn position_to_si(pose: &IsometryMatrix3<f64>) -> CartesianPosition {
    let Trsf { x, y, z, rx, ry, rz } = Trsf::from(*pose);
    let [rx, ry, rz] = [rx, ry, rz].map(f64::to_radians);
    CartesianPosition { x: x / MM, y: y / MM, z: z / MM, rx, ry, rz }
}

/// Converts a position to a pose in mm. No position is the identity.
pub(crate) fn pose_from_si(position: Option<&CartesianPosition>) -> IsometryMatrix3<f64> {
    let Some(position) = position else { return IsometryMatrix3::identity() };
    let translation = [position.x, position.y, position.z].map(|length| length * MM);
    Trsf::new(translation, [position.rx, position.ry, position.rz].map(f64::to_degrees)).isometry()
}
