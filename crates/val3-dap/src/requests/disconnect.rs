//! `disconnect`: ends the session.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::DisconnectArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;
use crate::session::NextAction;

/// The request `disconnect`.
pub(crate) enum Disconnect {}

impl DebugRequest for Disconnect {
    const COMMAND: &'static str = "disconnect";
    type Arguments = DisconnectArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        _: &mut DebuggedRun<'_>,
        arguments: DisconnectArguments,
    ) -> Result<(), RequestFailure> {
        let is_end = arguments.terminate_debuggee == Some(true);
        let is_suspended = arguments.suspend_debuggee == Some(true);
        session.action = Some(if is_end { NextAction::End } else { session.action_after_disconnect(is_suspended) });
        Ok(())
    }
}
