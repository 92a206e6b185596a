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

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::session::{NextAction, RunState};
    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn a_launched_run_ends_with_its_client() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.action("disconnect", json!({})), NextAction::End);
    }

    #[test]
    fn an_attached_run_continues_unless_the_client_suspends_it() {
        for is_suspended in [false, true] {
            let mut client = TestClient::attaching(EMPTY, RunState::Running);
            let action = client.action("disconnect", json!({ "suspendDebuggee": is_suspended }));
            assert_eq!(action, NextAction::Detach { is_suspended });
        }
    }

    #[test]
    fn a_client_can_end_an_attached_run() {
        let mut client = TestClient::attaching(EMPTY, RunState::Running);
        let arguments = json!({ "terminateDebuggee": true, "suspendDebuggee": true });
        assert_eq!(client.action("disconnect", arguments), NextAction::End);
    }

    #[test]
    fn a_session_with_wrong_arguments_continues() {
        let mut client = TestClient::stopped(EMPTY);
        let arguments = json!({ "terminateDebuggee": 1 });
        assert_eq!(client.action("disconnect", arguments.clone()), NextAction::Wait);
        assert_eq!(
            client.failure("disconnect", arguments),
            "the arguments of `disconnect` are wrong: invalid type: integer `1`, expected a boolean"
        );
    }
}
