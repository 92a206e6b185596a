//! `reverseKin`: the joints for a position of the flange. A failure is a result, not a fault.

use val3_kinematics::{Arm, Joints, RequestedConfiguration, Unreachable};
use val3_soap::v1::JointRange;
use val3_soap::v3::{ReverseKin, ReverseKinAnswer, ReversingResult};
use val3_soap::{ExceptionCode, SoapFault};

use crate::context::{Context, refused};
use crate::kinematics::{pose, requested};
use crate::units::{joints_from_si, joints_to_si};

/// Answers the request.
pub(super) fn answer(request: &ReverseKin, context: &mut Context<'_, '_>) -> Result<ReverseKinAnswer, SoapFault> {
    context.check_robot(request.robot)?;
    let near = context.joints(&request.near)?;
    let arm = context.controller().arm().model();
    let configuration = requested(arm, &request.config)?;
    let (joints, result) = match within(arm, &request.range)? {
        None => (near, ReversingResult::OutOfJointRange),
        Some(arm) => solve(&arm, request, &near, configuration),
    };
    Ok(ReverseKinAnswer { joints: joints_to_si(&joints, arm), result })
}

/// Arm with the permitted range of joints; `None` if an axis has no permitted position.
fn within(arm: &Arm, range: &JointRange) -> Result<Option<Arm>, SoapFault> {
    if range.min.is_empty() && range.max.is_empty() {
        return Ok(Some(arm.clone()));
    }
    let limits = joints_from_si(&range.min, arm).zip(joints_from_si(&range.max, arm));
    let (min, max) = limits.ok_or_else(|| {
        refused(ExceptionCode::InvalidNumberOfAxis, "the range needs two limits for each joint, or none")
    })?;
    Ok(arm.clone().with_limits(&min, &max).ok())
}

/// Joints and result. Without a solution, the joints are those near which it was searched.
fn solve(
    arm: &Arm,
    request: &ReverseKin,
    near: &Joints,
    configuration: RequestedConfiguration,
) -> (Joints, ReversingResult) {
    let Some(flange) = pose(&request.target) else { return (*near, ReversingResult::UnconstrainedFrame) };
    let flange = flange.into();
    match arm.solve(&flange, near, configuration) {
        Ok(joints) => (joints, ReversingResult::Ok),
        Err(_) if arm.solve(&flange, near, RequestedConfiguration::FREE).is_ok() => {
            (*near, ReversingResult::InvalidConfig)
        }
        Err(reason) => (*near, reason_of(reason)),
    }
}

fn reason_of(reason: Unreachable) -> ReversingResult {
    match reason {
        Unreachable::OutOfReach { .. } | Unreachable::InsideCylinder { .. } => ReversingResult::OutOfWorkspace,
        Unreachable::Limit { .. } => ReversingResult::OutOfJointRange,
        Unreachable::Tilted { .. } => ReversingResult::InvalidOrientation,
        Unreachable::NotConverged => ReversingResult::NoConvergence,
    }
}
