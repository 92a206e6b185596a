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
        _: &mut DebuggedRun<'_>,
        _: ReverseContinueArguments,
    ) -> Result<(), RequestFailure> {
        session.goal = Some(Goal::Breakpoint);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{COUNTER, EMPTY, FIRST_LINE, MAIN_THREAD, TestClient, source};

    #[test]
    fn a_run_returns_to_its_previous_breakpoint() {
        let listing = "num nCount\n\nprogram start()\nbegin\n  nCount=1\n  nCount=2\n  delay(1)\nend\n";
        let mut client = TestClient::stopped(listing);
        let breakpoints = json!({ "source": source("start"), "breakpoints": [{ "line": FIRST_LINE + 1 }] });
        let id = client.body("setBreakpoints", breakpoints)["breakpoints"][0]["id"].clone();
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        let stop = client.stop_after("reverseContinue", json!({ "threadId": MAIN_THREAD }));
        let expected = json!({ "reason": "breakpoint", "threadId": MAIN_THREAD, "allThreadsStopped": true, "hitBreakpointIds": [id] });
        assert_eq!(stop, expected);
        assert_eq!((client.place().1, client.value("nCount")), (FIRST_LINE + 1, json!("1")));
    }

    #[test]
    fn without_a_breakpoint_a_run_returns_to_its_beginning() {
        let mut client = TestClient::stopped(COUNTER);
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        let stop = client.stop_after("reverseContinue", json!({ "threadId": MAIN_THREAD }));
        let expected = json!({
            "reason": "entry",
            "description": "Paused at the beginning of the recorded past",
            "text": "the run begins here",
            "threadId": MAIN_THREAD,
            "allThreadsStopped": true,
        });
        assert_eq!(stop, expected);
        assert_eq!(client.value("nCount"), "0");
    }

    #[test]
    fn a_running_run_does_not_go_back() {
        let mut client = TestClient::launched(EMPTY, json!({}));
        assert_eq!(client.failure("reverseContinue", json!({ "threadId": MAIN_THREAD })), "notStopped");
    }
}
