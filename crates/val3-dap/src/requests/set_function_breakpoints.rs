//! `setFunctionBreakpoints`: replaces the breakpoints at the beginning of programs.

use crate::breakpoints;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{SetFunctionBreakpointsArguments, SetFunctionBreakpointsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `setFunctionBreakpoints`.
pub(crate) enum SetFunctionBreakpoints {}

impl DebugRequest for SetFunctionBreakpoints {
    const COMMAND: &'static str = "setFunctionBreakpoints";
    type Arguments = SetFunctionBreakpointsArguments;
    type Body = SetFunctionBreakpointsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SetFunctionBreakpointsArguments,
    ) -> Result<SetFunctionBreakpointsResponse, RequestFailure> {
        let breakpoints = session.breakpoints.set_programs(arguments.breakpoints, run, &session.conventions);
        Ok(SetFunctionBreakpointsResponse { breakpoints })
    }

    fn in_plain_run(arguments: &SetFunctionBreakpointsArguments) -> Option<SetFunctionBreakpointsResponse> {
        Some(SetFunctionBreakpointsResponse { breakpoints: breakpoints::ignored(arguments.breakpoints.len()) })
    }
}
