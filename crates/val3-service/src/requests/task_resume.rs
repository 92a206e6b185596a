//! `taskResume`: continues a task that a client or a breakpoint holds.

use val3_soap::v2::TaskResume;
use val3_soap::{Empty, SoapFault};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(request: &TaskResume, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    let task = context.target.task(request.task.as_deref(), request.created_by.as_deref())?;
    context.target.check_resumable(task)?;
    context.target.debugger.pause_task(task, false);
    Ok(Empty)
}
