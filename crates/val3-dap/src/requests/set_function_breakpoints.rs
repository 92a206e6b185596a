//! `setFunctionBreakpoints`: replaces the breakpoints at the beginning of programs.

use crate::breakpoint_hits::BreakpointGroup;
use crate::breakpoints;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{SetFunctionBreakpointsArguments, SetFunctionBreakpointsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `setFunctionBreakpoints`.
pub(crate) enum SetFunctionBreakpoints {}

impl DebugRequest for SetFunctionBreakpoints {
    const COMMAND: &'static str = "setFunctionBreakpoints";
    type Arguments = SetFunctionBreakpointsArguments;
    type Body = SetFunctionBreakpointsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SetFunctionBreakpointsArguments,
    ) -> Result<SetFunctionBreakpointsResponse, RequestFailure> {
        let mut breakpoints = session.breakpoints.set_programs(arguments.breakpoints, run, &session.conventions);
        session.shown_hits.replace(BreakpointGroup::Programs, &mut breakpoints, run.debugger);
        Ok(SetFunctionBreakpointsResponse { breakpoints })
    }

    fn in_plain_run(arguments: &SetFunctionBreakpointsArguments) -> Option<SetFunctionBreakpointsResponse> {
        Some(SetFunctionBreakpointsResponse { breakpoints: breakpoints::ignored(arguments.breakpoints.len()) })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;
    use crate::test_client::{CALLER, FIRST_LINE, MAIN_THREAD, TestClient, source};

    fn set(client: &mut TestClient, breakpoint: Value) -> Value {
        client.body("setFunctionBreakpoints", json!({ "breakpoints": [breakpoint] }))["breakpoints"][0].clone()
    }

    #[test]
    fn a_call_of_the_program_stops_the_run() {
        let mut client = TestClient::stopped(CALLER);
        let expected = json!({ "id": 1, "verified": true, "line": FIRST_LINE, "source": source("work") });
        assert_eq!(set(&mut client, json!({ "name": "work" })), expected);
        let stop = client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        let expected = json!({ "reason": "breakpoint", "threadId": MAIN_THREAD, "allThreadsStopped": true, "hitBreakpointIds": [1] });
        assert_eq!(stop, expected);
        assert_eq!(client.place(), ("main:work()".to_owned(), FIRST_LINE));
    }

    #[test]
    fn a_false_condition_does_not_stop_the_run() {
        let mut client = TestClient::stopped(CALLER);
        assert_eq!(set(&mut client, json!({ "name": "work", "condition": "1>2" }))["verified"], true);
        client.body("continue", json!({ "threadId": MAIN_THREAD }));
        assert!(!client.run().iter().any(|(event, _)| event == "stopped"));
    }

    #[test]
    fn unchanged_breakpoints_keep_their_ids() {
        let mut client = TestClient::stopped(CALLER);
        let mut ids = |breakpoints: Value| {
            let body = client.body("setFunctionBreakpoints", json!({ "breakpoints": breakpoints }));
            let set = body["breakpoints"].as_array().unwrap().iter();
            set.map(|breakpoint| breakpoint["id"].as_i64().unwrap()).collect::<Vec<_>>()
        };
        assert_eq!(ids(json!([{ "name": "work" }])), [1]);
        assert_eq!(ids(json!([{ "name": "start" }, { "name": "work" }])), [2, 1]);
        assert_eq!(ids(json!([{ "name": "work", "hitCondition": "2" }])), [3]);
    }

    #[test]
    fn unusable_breakpoints_are_not_verified() {
        let mut client = TestClient::stopped(CALLER);
        let expected = json!({
            "id": 1,
            "verified": false,
            "message": "nothing in memory has such a program yet",
            "reason": "pending",
        });
        assert_eq!(set(&mut client, json!({ "name": "other" })), expected);
        let mut message = |breakpoint| set(&mut client, breakpoint)["message"].clone();
        assert_eq!(
            message(json!({ "name": "work", "hitCondition": "often" })),
            "write a number of hits such as 5, >5, >=5, <5, <=5 or %5"
        );
        assert_eq!(
            message(json!({ "name": "work", "condition": "nOther>1" })),
            "`nOther` is not declared: no local variable, parameter or data has this name"
        );
    }

    #[test]
    fn a_run_without_debugging_ignores_breakpoints() {
        let arguments = serde_json::from_value(json!({ "breakpoints": [{ "name": "work" }] })).unwrap();
        let response = serde_json::to_value(SetFunctionBreakpoints::in_plain_run(&arguments)).unwrap();
        let expected = json!({ "breakpoints": [{ "verified": false, "message": "the run is not debugged" }] });
        assert_eq!(response, expected);
    }
}
