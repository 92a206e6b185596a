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

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::session::{NextAction, RunState};
    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn a_launched_run_is_restarted() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.action("restart", json!({})), NextAction::Restart);
    }

    #[test]
    fn an_attached_run_is_not_restarted() {
        let mut client = TestClient::attaching(EMPTY, RunState::Running);
        assert_eq!(
            client.failure("restart", json!({})),
            "a run that a client has attached to cannot be restarted: start it again"
        );
        assert_eq!(client.action("restart", json!({})), NextAction::Run);
    }
}
