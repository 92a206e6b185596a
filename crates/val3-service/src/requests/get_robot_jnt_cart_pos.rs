//! `getRobotJntCartPos`: joints, and the position of a tool in a frame.

use val3_soap::SoapFault;
use val3_soap::v0::{GetRobotJntCartPos, GetRobotJntCartPosAnswer};

use crate::context::Context;
use crate::units::{joints_to_si, pose_from_si, position_to_si};

/// Answers the request.
pub(super) fn answer(
    request: &GetRobotJntCartPos,
    context: &mut Context<'_, '_>,
) -> Result<GetRobotJntCartPosAnswer, SoapFault> {
    context.check_robot(request.robot)?;
    let arm = context.controller().arm();
    let joints = arm.sample().joints;
    let (tool, frame) = (pose_from_si(request.tool.as_ref()), pose_from_si(request.frame.as_ref()));
    let position = frame.inverse() * arm.model().flange(&joints) * tool;
    Ok(GetRobotJntCartPosAnswer { joints: joints_to_si(&joints, arm.model()), position: position_to_si(&position) })
}
