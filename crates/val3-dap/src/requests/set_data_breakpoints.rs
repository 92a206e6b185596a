//! `setDataBreakpoints`: replaces the breakpoints on data.

use crate::breakpoint_hits::BreakpointGroup;
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
        let mut breakpoints = session.breakpoints.set_data(&arguments.breakpoints, run);
        session.shown_hits.replace(BreakpointGroup::Data, &mut breakpoints, run.debugger);
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
            message(json!({ "dataId": "main:nCount", "condition": "nCount" })),
            "a condition is a bool, such as `nCount>3`"
        );
        assert_eq!(
            message(json!({ "dataId": "main:nCount", "hitCondition": "often" })),
            "write a number of hits such as 5, >5, >=5, <5, <=5 or %5"
        );
    }

    #[test]
    fn a_condition_chooses_the_changes() {
        let listing = "num nCount\n\nprogram start()\nbegin\n  nCount=1\n  nCount=2\n  nCount=3\n  delay(1)\nend\n";
        let mut client = TestClient::stopped(listing);
        client.body("dataBreakpointInfo", json!({ "name": "nCount" }));
        let breakpoint = json!({ "dataId": "main:nCount", "condition": "nCount>1", "hitCondition": "2" });
        assert_eq!(set(&mut client, breakpoint)["breakpoints"][0]["verified"], true);
        let stop = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop["text"], "2 -> 3 (main:start(), line 7)");
        set(&mut client, json!({ "dataId": "main:nCount", "condition": "nCount<3" }));
        let back = client.stop_after("reverseContinue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(back["text"], "1 -> 2 (main:start(), line 6)");
        client.stop_after("reverseContinue", json!({ "threadId": MAIN_THREAD }));
        set(&mut client, json!({ "dataId": "main:nCount", "condition": "1/(nCount-2)>0" }));
        let fault = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        let expected = "the condition cannot be evaluated: error 10: division by zero (main:start(), line 6)";
        assert_eq!(fault["text"], expected);
    }

    #[test]
    fn a_local_of_an_ended_program_is_no_longer_watched() {
        let listing = "program start()\nbegin\n  call work()\n  delay(1)\n  delay(1)\nend\n\n\
                       program work()\n  num l_nAt\nbegin\n  l_nAt=1\nend\n";
        let mut client = TestClient::stopped(listing);
        client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD }));
        let (_, frame) = client.thread_and_frame();
        let data = client.body("dataBreakpointInfo", json!({ "name": "l_nAt", "frameId": frame }))["dataId"].clone();
        assert_eq!(set(&mut client, json!({ "dataId": data }))["breakpoints"][0]["verified"], true);
        let mut events = Vec::new();
        for _ in 0..2 {
            events.extend(client.events("next", json!({ "threadId": MAIN_THREAD })));
            events.extend(client.run());
        }
        let mut changes = events.iter().filter(|(event, _)| event == "breakpoint").map(|(_, body)| &body["breakpoint"]);
        assert_eq!(changes.next().expect("the first step has changed the variable")["message"], "hit once");
        let changed = changes.find(|changed| changed["verified"] == false).expect("the program has ended");
        assert_eq!(changed["message"], "the program of this variable has ended: a later call has a new variable");
        let again = set(&mut client, json!({ "dataId": data }));
        assert_eq!(again["breakpoints"][0]["verified"], false, "{again}");
    }

    #[test]
    fn a_run_without_debugging_ignores_breakpoints() {
        let arguments = serde_json::from_value(json!({ "breakpoints": [{ "dataId": "main:nCount" }] })).unwrap();
        let response = serde_json::to_value(SetDataBreakpoints::in_plain_run(&arguments)).unwrap();
        let expected = json!({ "breakpoints": [{ "verified": false, "message": "the run is not debugged" }] });
        assert_eq!(response, expected);
    }
}
