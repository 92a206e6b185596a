//! `schedulerRefresh`: whether all moves are done, and the commanded position of the arm.

use val3_soap::SoapFault;
use val3_soap::v3::{RobotPosition, SchedulerRefresh, SchedulerRefreshAnswer, SchedulingMode};

use crate::context::Context;
use crate::kinematics::{config, matrix};
use crate::units::joints_to_si;

/// Answers the request.
pub(super) fn answer(_: &SchedulerRefresh, context: &mut Context<'_, '_>) -> Result<SchedulerRefreshAnswer, SoapFault> {
    let arm = context.controller().arm();
    let (model, joints) = (arm.model(), arm.sample().joints);
    let robot = RobotPosition {
        settled: arm.is_settled(),
        joints: joints_to_si(&joints, model),
        position: matrix(&model.flange(&joints)),
        config: config(model, &joints),
    };
    Ok(SchedulerRefreshAnswer { mode: SchedulingMode::Internal, is_empty: arm.is_empty(), robots: vec![robot] })
}
