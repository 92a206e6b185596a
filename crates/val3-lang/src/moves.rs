//! Poses of points, frames and tools in mm, and move requests with these poses (9.6.3, 10.6, 11.1, 11.2).

use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::Joints;
use val3_moves::{Manner, MovePath, MoveTarget, Percent};

use crate::call::{Call, Flow, FrameRef, PointRef, PointValue, StoredValue, ToolRef, Wait};
use crate::fault::{Fault, Result};
use crate::memory::LinkPlace;
use crate::ports::MoveRequest;
use crate::references;
use crate::runtime_errors::{ANOTHER_ARM, INVALID_PARAMETER};
use crate::types::Arm;
use crate::values::{ConfigValue, JointValue, MdescValue};

/// Maximum force of a compliant move, in per cent of the nominal load (11.1.4).
const GREATEST_FORCE: f64 = 1000.0;

/// Path of a joint move to a joint position.
///
/// # Errors
/// 81 for a controller with another kind of arm.
pub(crate) fn joint_path(call: &mut Call<'_>, joint: JointValue) -> Result<MovePath> {
    check_arm(call)?;
    Ok(MovePath::Joint(to_arm(call, joint)))
}

/// Path of a joint move to a point.
///
/// # Errors
/// 81 for a controller with another kind of arm, 161 to 163 if the pose cannot be computed.
pub(crate) fn joint_path_to_point(call: &mut Call<'_>, point: PointRef) -> Result<MovePath> {
    check_arm(call)?;
    Ok(MovePath::JointToPoint(move_target(call, point)?))
}

/// Straight path to a point.
///
/// # Errors
/// 81 for a controller with another kind of arm, 161 to 163 if the pose cannot be computed.
pub(crate) fn line(call: &mut Call<'_>, point: PointRef) -> Result<MovePath> {
    check_arm(call)?;
    Ok(MovePath::Line(move_target(call, point)?))
}

/// Circular path through an intermediate point to a point.
///
/// # Errors
/// 81 for a controller with another kind of arm, 161 to 163 if the pose cannot be computed.
pub(crate) fn circle(call: &mut Call<'_>, intermediate: PointRef, point: PointRef) -> Result<MovePath> {
    check_arm(call)?;
    Ok(MovePath::Circle(pose_of_point(call, intermediate)?, move_target(call, point)?))
}

/// Records a move and returns its id. The task waits while no more moves can be recorded.
///
/// # Errors
/// 100 to 106, 150, 154, 160, 164, 250.
pub(crate) fn record(
    call: &mut Call<'_>,
    instruction: &'static str,
    path: MovePath,
    tool: ToolRef,
    descriptor: MdescValue,
    manner: Manner,
) -> Result<Flow<f64>> {
    let tool = pose_of_tool(call, tool)?;
    let descriptor = descriptor.checked(call.unit.millimetres())?;
    let request = MoveRequest { instruction, path, tool, descriptor, manner };
    Ok(call.ports.record_move(&request)?.map_or(Flow::Wait(Wait::FOR_OTHERS), Flow::Done))
}

/// Returns the compliant manner with a force in per cent of the nominal load.
///
/// # Errors
/// 70 if the force exceeds 1000 per cent in either direction.
pub(crate) fn compliant(force: f64) -> Result<Manner> {
    if force.abs() <= GREATEST_FORCE { Ok(Manner::Compliant(Percent(force))) } else { Err(Fault(INVALID_PARAMETER)) }
}

/// Checks that the application's positions are for the controller's kind of arm.
///
/// # Errors
/// 81 for another kind of arm.
pub(crate) fn check_arm(call: &mut Call<'_>) -> Result<()> {
    let own = if call.ports.arm().is_scara() { Arm::Scara } else { Arm::SixAxis };
    if call.arm.is_some_and(|arm| arm != own) { Err(Fault(ANOTHER_ARM)) } else { Ok(()) }
}

fn move_target(call: &Call<'_>, point: PointRef) -> Result<MoveTarget> {
    let configuration = PointValue::read(call.memory, point.0)?.config.requested();
    Ok(MoveTarget { pose: pose_of_point(call, point)?, configuration })
}

/// Returns a point's pose in `world`.
///
/// # Errors
/// 161 to 163.
pub(crate) fn pose_of_point(call: &Call<'_>, point: PointRef) -> Result<IsometryMatrix3<f64>> {
    references::of_point(call.memory, point).map(|way| references::in_millimetres(&way, call.unit))
}

/// Returns a frame's pose in `world`.
///
/// # Errors
/// 161, 163.
pub(crate) fn pose_of_frame(call: &Call<'_>, frame: FrameRef) -> Result<IsometryMatrix3<f64>> {
    references::of_frame(call.memory, frame).map(|way| references::in_millimetres(&way, call.unit))
}

/// Returns a tool centre point's pose on the flange.
///
/// # Errors
/// 160, 164.
pub(crate) fn pose_of_tool(call: &Call<'_>, tool: ToolRef) -> Result<IsometryMatrix3<f64>> {
    references::of_tool(call.memory, tool).map(|way| references::in_millimetres(&way, call.unit))
}

/// Converts a transformation from the application's length unit to mm.
pub(crate) fn in_millimetres(call: &Call<'_>, trsf: &Trsf) -> IsometryMatrix3<f64> {
    trsf.scaled(call.unit.millimetres()).isometry()
}

/// Converts a joint position of the application to degrees and mm.
pub(crate) fn to_arm(call: &mut Call<'_>, joint: JointValue) -> Joints {
    joint.joints(call.ports.arm(), call.unit.millimetres())
}

/// Converts a joint position of the arm, in degrees and mm, to the application's length unit.
pub(crate) fn of_arm(call: &mut Call<'_>, joints: Joints) -> JointValue {
    JointValue::of(joints, call.ports.arm(), call.unit.millimetres())
}

/// Returns a tool's pose at a joint position of the arm, as a point in `frame` with the arm's configuration.
///
/// # Errors
/// 160, 161, 163, 164.
pub(crate) fn point_at(call: &mut Call<'_>, joint: &Joints, tool: ToolRef, frame: FrameRef) -> Result<PointValue> {
    let tool = pose_of_tool(call, tool)?;
    let reference = pose_of_frame(call, frame)?;
    let arm = call.ports.arm();
    let config = ConfigValue::at(arm, joint);
    let seen = Trsf::from(reference.inverse() * arm.flange(joint) * tool);
    Ok(PointValue { trsf: seen.scaled(1.0 / call.unit.millimetres()), config, frame: LinkPlace::Data(frame.0) })
}

#[cfg(test)]
mod tests;
