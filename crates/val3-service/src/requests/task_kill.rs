//! `taskKill`: ends a task.

use val3_soap::v2::TaskKill;
use val3_soap::{Empty, SoapFault};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(request: &TaskKill, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    let task = context.target.task(request.task.as_deref(), request.created_by.as_deref())?;
    context.controller().kill(task);
    Ok(Empty)
}
