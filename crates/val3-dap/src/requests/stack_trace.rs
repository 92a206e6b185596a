//! `stackTrace`: stack frames of a task.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{StackTraceArguments, StackTraceResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `stackTrace`.
pub(crate) enum StackTrace {}

impl DebugRequest for StackTrace {
    const COMMAND: &'static str = "stackTrace";
    type Arguments = StackTraceArguments;
    type Body = StackTraceResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: StackTraceArguments,
    ) -> Result<StackTraceResponse, RequestFailure> {
        let trace = session.handles.stack_trace(&arguments, &run.debugger.controller, &session.conventions);
        trace.ok_or(RequestFailure::NoSuchTask)
    }
}
