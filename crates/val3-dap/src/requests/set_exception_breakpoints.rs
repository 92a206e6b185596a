//! `setExceptionBreakpoints`: selects the errors that stop the run.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{SetExceptionBreakpointsArguments, SetExceptionBreakpointsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `setExceptionBreakpoints`.
pub(crate) enum SetExceptionBreakpoints {}

impl DebugRequest for SetExceptionBreakpoints {
    const COMMAND: &'static str = "setExceptionBreakpoints";
    type Arguments = SetExceptionBreakpointsArguments;
    type Body = SetExceptionBreakpointsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SetExceptionBreakpointsArguments,
    ) -> Result<SetExceptionBreakpointsResponse, RequestFailure> {
        let breakpoints = Some(session.breakpoints.set_errors(&arguments, run, &session.conventions));
        Ok(SetExceptionBreakpointsResponse { breakpoints })
    }

    fn in_plain_run(_: &SetExceptionBreakpointsArguments) -> Option<SetExceptionBreakpointsResponse> {
        Some(SetExceptionBreakpointsResponse::default())
    }
}
