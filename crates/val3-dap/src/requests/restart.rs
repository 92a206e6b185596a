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
    use crate::test_client::{COUNTER, EMPTY, FIRST_LINE, MAIN_THREAD, TestClient, source};

    #[test]
    fn a_launched_run_is_restarted() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.action("restart", json!({})), NextAction::Restart);
    }

    #[test]
    fn a_restarted_run_has_the_breakpoints_of_the_client() {
        let mut client = TestClient::stopped(COUNTER);
        let breakpoints = json!({ "source": source("start"), "breakpoints": [{ "line": FIRST_LINE + 1 }] });
        client.body("setBreakpoints", breakpoints);
        client.body("restart", json!({}));
        client.open_again(COUNTER);
        assert_eq!(client.place().1, FIRST_LINE);
        let stop = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop["hitBreakpointIds"], json!([1]));
        assert_eq!(client.place().1, FIRST_LINE + 1);
    }

    #[test]
    fn a_restarted_run_has_no_breakpoints_on_data() {
        let mut client = TestClient::stopped(COUNTER);
        let data = client.body("dataBreakpointInfo", json!({ "name": "nCount" }))["dataId"].clone();
        let breakpoints = json!({ "breakpoints": [{ "dataId": data }] });
        client.body("setDataBreakpoints", breakpoints.clone());
        client.body("restart", json!({}));
        let removed = json!({
            "reason": "changed",
            "breakpoint": {
                "id": 1,
                "verified": false,
                "message": "the application was opened again: set the breakpoint again",
                "reason": "failed",
            },
        });
        assert!(client.open_again(COUNTER).contains(&("breakpoint".to_owned(), removed)));
        let message = client.body("setDataBreakpoints", breakpoints)["breakpoints"][0]["message"].clone();
        assert_eq!(message, "`main:nCount` is not known in this run");
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
