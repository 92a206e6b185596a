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

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, MAIN_THREAD, TestClient};

    #[test]
    fn a_running_run_stops() {
        let mut client = TestClient::launched(EMPTY, json!({}));
        let stop = client.stop_after("pause", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop, json!({ "reason": "pause", "threadId": MAIN_THREAD, "allThreadsStopped": true }));
    }

    #[test]
    fn only_the_task_stops_if_the_session_stops_single_tasks() {
        let mut client = TestClient::launched(EMPTY, json!({ "stopScope": "task" }));
        let stop = client.stop_after("pause", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop, json!({ "reason": "pause", "threadId": MAIN_THREAD, "allThreadsStopped": false }));
    }

    #[test]
    fn an_unknown_task_pauses_the_run() {
        let mut client = TestClient::launched(EMPTY, json!({ "stopScope": "task" }));
        let stop = client.stop_after("pause", json!({ "threadId": 9 }));
        assert_eq!(stop, json!({ "reason": "pause", "threadId": MAIN_THREAD, "allThreadsStopped": true }));
    }

    #[test]
    fn a_stopped_run_does_not_stop_once_more() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.events("pause", json!({ "threadId": MAIN_THREAD })), []);
    }

    #[test]
    fn a_thread_is_required() {
        let mut client = TestClient::launched(EMPTY, json!({}));
        let reason = client.failure("pause", json!({}));
        assert_eq!(reason, "the arguments of `pause` are wrong: missing field `threadId`");
    }
}
