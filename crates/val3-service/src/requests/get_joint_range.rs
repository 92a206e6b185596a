//! `getJointRange`: the limits of the joints, as the cell narrows them.

use val3_soap::SoapFault;
use val3_soap::v1::{GetJointRange, GetJointRangeAnswer, JointRange};

use crate::context::Context;
use crate::units::joints_to_si;

/// Answers the request.
pub(super) fn answer(request: &GetJointRange, context: &mut Context<'_, '_>) -> Result<GetJointRangeAnswer, SoapFault> {
    context.check_robot(request.robot)?;
    let arm = context.controller().arm().model();
    let (min, max): (Vec<f64>, Vec<f64>) = arm.limits().iter().map(|axis| (axis.min, axis.max)).unzip();
    let range = JointRange { min: joints_to_si(&min, arm), max: joints_to_si(&max, arm) };
    Ok(GetJointRangeAnswer { range })
}
