//! `setBreakpoints`: replaces the breakpoints of a file.

use crate::breakpoints;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{SetBreakpointsArguments, SetBreakpointsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `setBreakpoints`.
pub(crate) enum SetBreakpoints {}

impl DebugRequest for SetBreakpoints {
    const COMMAND: &'static str = "setBreakpoints";
    type Arguments = SetBreakpointsArguments;
    type Body = SetBreakpointsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SetBreakpointsArguments,
    ) -> Result<SetBreakpointsResponse, RequestFailure> {
        let breakpoints = session.breakpoints.set(arguments, run, &session.conventions);
        Ok(SetBreakpointsResponse { breakpoints })
    }

    fn in_plain_run(arguments: &SetBreakpointsArguments) -> Option<SetBreakpointsResponse> {
        let SetBreakpointsArguments { breakpoints, lines, .. } = arguments;
        let count = breakpoints.as_ref().map(Vec::len).or(lines.as_ref().map(Vec::len)).unwrap_or_default();
        Some(SetBreakpointsResponse { breakpoints: breakpoints::ignored(count) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_without_debugging_ignores_breakpoints() {
        let arguments = SetBreakpointsArguments { lines: Some(vec![1, 2]), ..SetBreakpointsArguments::default() };
        let response = SetBreakpoints::in_plain_run(&arguments).unwrap();
        let messages = response.breakpoints.iter().map(|breakpoint| breakpoint.message.as_deref());
        assert_eq!(messages.collect::<Vec<_>>(), [Some("the run is not debugged"); 2]);
    }
}
