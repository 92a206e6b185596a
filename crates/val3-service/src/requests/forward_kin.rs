//! `forwardKin`: the flange in `world`.

use val3_soap::SoapFault;
use val3_soap::v3::{ForwardKin, ForwardKinAnswer};

use crate::context::Context;
use crate::kinematics::{config, matrix};

/// Answers the request.
pub(super) fn answer(request: &ForwardKin, context: &mut Context<'_, '_>) -> Result<ForwardKinAnswer, SoapFault> {
    context.check_robot(request.robot)?;
    let joints = context.joints(&request.joints)?;
    let arm = context.controller().arm().model();
    Ok(ForwardKinAnswer { position: matrix(&arm.flange(&joints)), config: config(arm, &joints) })
}
