//! `setDataBreakpoints`: replaces the breakpoints on data.

use crate::breakpoints;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{SetDataBreakpointsArguments, SetDataBreakpointsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `setDataBreakpoints`.
pub(crate) enum SetDataBreakpoints {}

impl DebugRequest for SetDataBreakpoints {
    const COMMAND: &'static str = "setDataBreakpoints";
    type Arguments = SetDataBreakpointsArguments;
    type Body = SetDataBreakpointsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SetDataBreakpointsArguments,
    ) -> Result<SetDataBreakpointsResponse, RequestFailure> {
        let breakpoints = session.breakpoints.set_data(&arguments.breakpoints, run);
        Ok(SetDataBreakpointsResponse { breakpoints })
    }

    fn in_plain_run(arguments: &SetDataBreakpointsArguments) -> Option<SetDataBreakpointsResponse> {
        Some(SetDataBreakpointsResponse { breakpoints: breakpoints::ignored(arguments.breakpoints.len()) })
    }
}
