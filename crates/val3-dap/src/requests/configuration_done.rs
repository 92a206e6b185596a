//! `configurationDone`: the client has set its breakpoints.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::ConfigurationDoneArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `configurationDone`.
pub(crate) enum ConfigurationDone {}

impl DebugRequest for ConfigurationDone {
    const COMMAND: &'static str = "configurationDone";
    type Arguments = ConfigurationDoneArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        _: ConfigurationDoneArguments,
    ) -> Result<(), RequestFailure> {
        session.finish_configuration(run);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::session::{NextAction, RunState};
    use crate::test_client::{EMPTY, MAIN_THREAD, MODULE, TestClient, source};

    fn event(name: &str, body: Value) -> (String, Value) {
        (name.to_owned(), body)
    }

    #[test]
    fn the_response_is_followed_by_the_state_of_the_run() {
        let mut client = TestClient::launching(EMPTY, json!({ "stopOnEntry": true }));
        let module = json!({ "id": MODULE, "name": "main", "path": MODULE, "isUserCode": true });
        let expected = [
            event("process", json!({ "name": "main", "isLocalProcess": true, "startMethod": "launch" })),
            event("module", json!({ "reason": "new", "module": module })),
            event("loadedSource", json!({ "reason": "new", "source": source("start") })),
            event("thread", json!({ "reason": "started", "threadId": MAIN_THREAD })),
            event("stopped", json!({ "reason": "entry", "threadId": MAIN_THREAD, "allThreadsStopped": true })),
        ];
        assert_eq!(client.events("configurationDone", json!({})), expected);
    }

    #[test]
    fn a_second_request_has_no_effect() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.events("configurationDone", json!({})), []);
    }

    #[test]
    fn a_run_begins_without_a_stop_on_entry() {
        let mut client = TestClient::launching(EMPTY, json!({}));
        assert_eq!(client.action("threads", json!({})), NextAction::Wait);
        assert_eq!(client.action("configurationDone", json!({})), NextAction::Run);
    }

    #[test]
    fn a_run_that_the_last_client_suspended_stays_stopped() {
        let mut client = TestClient::attaching(EMPTY, RunState::Suspended);
        let events = client.events("configurationDone", json!({}));
        let stop = json!({ "reason": "pause", "threadId": MAIN_THREAD, "allThreadsStopped": true });
        assert_eq!(events.last(), Some(&event("stopped", stop)));
    }

    #[test]
    fn a_running_run_continues() {
        let mut client = TestClient::attaching(EMPTY, RunState::Running);
        assert_eq!(client.action("configurationDone", json!({})), NextAction::Run);
    }
}
