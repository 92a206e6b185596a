//! `reverseContinue`: returns to the previous breakpoint.

use val3_debug::Goal;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::ReverseContinueArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `reverseContinue`.
pub(crate) enum ReverseContinue {}

impl DebugRequest for ReverseContinue {
    const COMMAND: &'static str = "reverseContinue";
    type Arguments = ReverseContinueArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        _: ReverseContinueArguments,
    ) -> Result<(), RequestFailure> {
        session.go_back(Goal::Breakpoint, run)
    }
}
