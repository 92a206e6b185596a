//! `pause`: stops the run, or one task.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::PauseArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `pause`.
pub(crate) enum Pause {}

impl DebugRequest for Pause {
    const COMMAND: &'static str = "pause";
    type Arguments = PauseArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: PauseArguments,
    ) -> Result<(), RequestFailure> {
        session.pause(arguments.thread_id, run);
        Ok(())
    }
}
