//! `taskStep`: steps a held task, and holds it after the step. The answer does not wait for the step.

use val3_debug::StepKind;
use val3_soap::v2::{TaskStep, TaskStepKind};
use val3_soap::{Empty, SoapFault};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(request: &TaskStep, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    let task = context.target.task(request.task.as_deref(), request.created_by.as_deref())?;
    context.target.check_resumable(task)?;
    context.debug()?;
    let debugger = &mut *context.target.debugger;
    debugger.stop_tasks_alone(true);
    debugger.pause_task(task, false);
    debugger.step(
        task,
        match request.step {
            TaskStepKind::Into => StepKind::In,
            TaskStepKind::Over => StepKind::Over,
            TaskStepKind::Out => StepKind::Out,
        },
    );
    Ok(Empty)
}
