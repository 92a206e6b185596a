//! `setDataBreakpoints`: replaces the breakpoints on data.

use crate::breakpoints;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{SetDataBreakpointsArguments, SetDataBreakpointsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `setDataBreakpoints`.
pub(crate) enum SetDataBreakpoints {}

impl DebugRequest for SetDataBreakpoints {
    const COMMAND: &'static str = "setDataBreakpoints";
    type Arguments = SetDataBreakpointsArguments;
    type Body = SetDataBreakpointsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SetDataBreakpointsArguments,
    ) -> Result<SetDataBreakpointsResponse, RequestFailure> {
        let breakpoints = session.breakpoints.set_data(&arguments.breakpoints, run);
        Ok(SetDataBreakpointsResponse { breakpoints })
    }

    fn in_plain_run(arguments: &SetDataBreakpointsArguments) -> Option<SetDataBreakpointsResponse> {
        Some(SetDataBreakpointsResponse { breakpoints: breakpoints::ignored(arguments.breakpoints.len()) })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;
    use crate::test_client::{COUNTER, MAIN_THREAD, TestClient};

    /// Returns the client of a run in which `main:nCount` can have a breakpoint.
    fn client() -> TestClient {
        let mut client = TestClient::stopped(COUNTER);
        client.body("dataBreakpointInfo", json!({ "name": "nCount" }));
        client
    }

    fn set(client: &mut TestClient, breakpoint: Value) -> Value {
        client.body("setDataBreakpoints", json!({ "breakpoints": [breakpoint] }))
    }

    #[test]
    fn a_line_that_changes_the_data_stops_the_run() {
        let mut client = client();
        let expected = json!({ "breakpoints": [{ "id": 1, "verified": true }] });
        assert_eq!(set(&mut client, json!({ "dataId": "main:nCount" })), expected);
        let expected = json!({
            "reason": "data breakpoint",
            "text": "0 -> 1 (main:start(), line 5)",
            "threadId": MAIN_THREAD,
            "allThreadsStopped": true,
            "hitBreakpointIds": [1],
        });
        assert_eq!(client.stop_after("continue", json!({ "threadId": MAIN_THREAD })), expected);
    }

    #[test]
    fn a_line_that_reads_the_data_stops_the_run() {
        let listing = "num nCount\n\nprogram start()\nbegin\n  delay(nCount)\n  delay(1)\nend\n";
        let mut client = TestClient::stopped(listing);
        client.body("dataBreakpointInfo", json!({ "name": "nCount" }));
        set(&mut client, json!({ "dataId": "main:nCount", "accessType": "read" }));
        let stop = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop["text"], "read: 0 (main:start(), line 5)");
    }

    #[test]
    fn a_new_list_replaces_the_breakpoints() {
        let mut client = client();
        set(&mut client, json!({ "dataId": "main:nCount" }));
        client.body("setDataBreakpoints", json!({ "breakpoints": [] }));
        client.body("continue", json!({ "threadId": MAIN_THREAD }));
        assert!(!client.run().iter().any(|(event, _)| event == "stopped"));
    }

    #[test]
    fn unusable_breakpoints_are_not_verified() {
        let mut client = client();
        let mut message = |breakpoint| set(&mut client, breakpoint)["breakpoints"][0]["message"].clone();
        assert_eq!(message(json!({ "dataId": "main:nOther" })), "`main:nOther` is not known in this run");
        assert_eq!(
            message(json!({ "dataId": "main:nCount", "condition": "nCount>1" })),
            "breakpoints on data have no condition: use a number of hits"
        );
        assert_eq!(
            message(json!({ "dataId": "main:nCount", "hitCondition": "often" })),
            "write a number of hits such as 5, >5, >=5, <5, <=5 or %5"
        );
    }

    #[test]
    fn a_run_without_debugging_ignores_breakpoints() {
        let arguments = serde_json::from_value(json!({ "breakpoints": [{ "dataId": "main:nCount" }] })).unwrap();
        let response = serde_json::to_value(SetDataBreakpoints::in_plain_run(&arguments)).unwrap();
        let expected = json!({ "breakpoints": [{ "verified": false, "message": "the run is not debugged" }] });
        assert_eq!(response, expected);
    }
}
