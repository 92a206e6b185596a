//! `breakpointLocations`: lines of a file that can have breakpoints.

use crate::breakpoints;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{BreakpointLocationsArguments, BreakpointLocationsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `breakpointLocations`.
pub(crate) enum BreakpointLocations {}

impl DebugRequest for BreakpointLocations {
    const COMMAND: &'static str = "breakpointLocations";
    type Arguments = BreakpointLocationsArguments;
    type Body = BreakpointLocationsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: BreakpointLocationsArguments,
    ) -> Result<BreakpointLocationsResponse, RequestFailure> {
        let breakpoints = breakpoints::locations(&arguments, &run.debugger.controller, &session.conventions);
        Ok(BreakpointLocationsResponse { breakpoints })
    }
}
