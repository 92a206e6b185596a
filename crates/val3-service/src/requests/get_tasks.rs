//! `getTasks`: all tasks, in the order of creation.

use val3_soap::SoapFault;
use val3_soap::v2::{GetTasks, GetTasksAnswer};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(_: &GetTasks, context: &mut Context<'_, '_>) -> Result<GetTasksAnswer, SoapFault> {
    Ok(GetTasksAnswer { tasks: context.target.task_statuses() })
}
