//! `val3/pose`: position and motion of the arm.

use val3_machine::event::seconds;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::moves::ArmSample;
use crate::requests::{DebugRequest, NoArguments};
use crate::session::DebugSession;

/// The request `val3/pose`.
pub(crate) enum Pose {}

impl DebugRequest for Pose {
    const COMMAND: &'static str = "val3/pose";
    type Arguments = NoArguments;
    type Body = ArmSample;

    fn answer(_: &mut DebugSession, run: &mut DebuggedRun<'_>, _: NoArguments) -> Result<ArmSample, RequestFailure> {
        let controller = &run.debugger.controller;
        Ok(ArmSample::new(seconds(controller.now()), controller))
    }
}
