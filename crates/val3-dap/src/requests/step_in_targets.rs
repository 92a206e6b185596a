//! `stepInTargets`: program that the next line of a stack frame calls.

use val3_debug::StepKind;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::inspection::FrameHandle;
use crate::protocol::StepInTarget;
use crate::protocol::{StepInTargetsArguments, StepInTargetsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `stepInTargets`.
pub(crate) enum StepInTargets {}

impl DebugRequest for StepInTargets {
    const COMMAND: &'static str = "stepInTargets";
    type Arguments = StepInTargetsArguments;
    type Body = StepInTargetsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: StepInTargetsArguments,
    ) -> Result<StepInTargetsResponse, RequestFailure> {
        let frame = session.handles.frame(arguments.frame_id).ok_or(RequestFailure::Stale)?;
        Ok(StepInTargetsResponse { targets: targets(frame, run) })
    }
}

/// Returns the call of the next line. Only the innermost stack frame has a next line.
fn targets(FrameHandle { task, depth }: FrameHandle, run: &DebuggedRun<'_>) -> Vec<StepInTarget> {
    let call = run.debugger.step_in_target(task).filter(|_| depth == 0);
    let target = call.map(|call| {
        let label = format!("{}:{}()", call.application, call.program);
        let label = if call.kind == StepKind::IntoTask { format!("the task of {label}") } else { label };
        StepInTarget { id: 1, label, ..StepInTarget::default() }
    });
    target.into_iter().collect()
}
