//! `restart`: opens the application again and runs it from its beginning.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::RestartArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;
use crate::session::NextAction;

/// The request `restart`.
pub(crate) enum Restart {}

impl DebugRequest for Restart {
    const COMMAND: &'static str = "restart";
    type Arguments = RestartArguments;
    type Body = ();

    fn answer(session: &mut DebugSession, _: &mut DebuggedRun<'_>, _: RestartArguments) -> Result<(), RequestFailure> {
        if session.start.is_attach {
            return Err(RequestFailure::AttachedRestart);
        }
        session.action = Some(NextAction::Restart);
        Ok(())
    }
}
