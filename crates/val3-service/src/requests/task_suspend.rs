//! `taskSuspend`: holds a task. Other tasks and the arm continue.

use val3_soap::v2::TaskSuspend;
use val3_soap::{Empty, SoapFault};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(request: &TaskSuspend, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    let task = context.target.task(request.task.as_deref(), request.created_by.as_deref())?;
    context.target.debugger.pause_task(task, true);
    Ok(Empty)
}
