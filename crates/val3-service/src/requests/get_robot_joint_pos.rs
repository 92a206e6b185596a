//! `getRobotJointPos`: the commanded joints, as in the trace of a run.

use val3_soap::SoapFault;
use val3_soap::v0::{GetRobotJointPos, GetRobotJointPosAnswer};

use crate::context::Context;
use crate::units::joints_to_si;

/// Answers the request.
pub(super) fn answer(
    request: &GetRobotJointPos,
    context: &mut Context<'_, '_>,
) -> Result<GetRobotJointPosAnswer, SoapFault> {
    context.check_robot(request.robot)?;
    let arm = context.controller().arm();
    Ok(GetRobotJointPosAnswer { position: joints_to_si(&arm.sample().joints, arm.model()) })
}
