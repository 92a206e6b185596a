//! `setExceptionBreakpoints`: selects the errors that stop the run.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{SetExceptionBreakpointsArguments, SetExceptionBreakpointsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `setExceptionBreakpoints`.
pub(crate) enum SetExceptionBreakpoints {}

impl DebugRequest for SetExceptionBreakpoints {
    const COMMAND: &'static str = "setExceptionBreakpoints";
    type Arguments = SetExceptionBreakpointsArguments;
    type Body = SetExceptionBreakpointsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SetExceptionBreakpointsArguments,
    ) -> Result<SetExceptionBreakpointsResponse, RequestFailure> {
        let breakpoints = Some(session.breakpoints.set_errors(&arguments, run, &session.conventions));
        Ok(SetExceptionBreakpointsResponse { breakpoints })
    }

    fn in_plain_run(_: &SetExceptionBreakpointsArguments) -> Option<SetExceptionBreakpointsResponse> {
        Some(SetExceptionBreakpointsResponse::default())
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;
    use crate::test_client::{EMPTY, MAIN_THREAD, TestClient};

    const DIVISION: &str = "num nCount\n\nprogram start()\nbegin\n  nCount=1/nCount\nend\n";

    fn set(client: &mut TestClient, arguments: Value) -> Value {
        client.body("setExceptionBreakpoints", arguments)
    }

    #[test]
    fn a_chosen_error_stops_the_run() {
        for filters in [
            json!({ "filters": ["all"] }),
            json!({ "filters": ["unhandled"] }),
            json!({ "filters": [], "filterOptions": [{ "filterId": "codes", "condition": "70, 10" }] }),
        ] {
            let mut client = TestClient::stopped(DIVISION);
            assert_eq!(
                set(&mut client, filters.clone()),
                json!({ "breakpoints": [{ "verified": true }] }),
                "{filters}"
            );
            let expected = json!({
                "reason": "exception",
                "description": "Paused on run-time error",
                "text": "error 10: division by zero",
                "threadId": MAIN_THREAD,
                "allThreadsStopped": true,
            });
            assert_eq!(client.stop_after("continue", json!({ "threadId": MAIN_THREAD })), expected, "{filters}");
        }
    }

    #[test]
    fn other_errors_do_not_stop_the_run() {
        let mut client = TestClient::stopped(DIVISION);
        let codes = json!({ "filters": ["motion"], "filterOptions": [{ "filterId": "codes", "condition": "11" }] });
        set(&mut client, codes);
        client.body("continue", json!({ "threadId": MAIN_THREAD }));
        assert!(!client.run().iter().any(|(event, _)| event == "stopped"));
    }

    #[test]
    fn results_follow_the_order_of_filters_and_options() {
        let mut client = TestClient::stopped(EMPTY);
        let options = json!([{ "filterId": "codes", "condition": "10, x" }, { "filterId": "assertion" }]);
        let expected = json!({ "breakpoints": [
            { "verified": false, "message": "there is no filter `none`" },
            { "verified": true },
            { "verified": false, "message": "`x` is not the number of a run-time error" },
            { "verified": true },
        ] });
        assert_eq!(set(&mut client, json!({ "filters": ["none", "all"], "filterOptions": options })), expected);
    }

    #[test]
    fn a_run_without_debugging_has_no_results() {
        let arguments = SetExceptionBreakpointsArguments::default();
        let response = SetExceptionBreakpoints::in_plain_run(&arguments);
        assert_eq!(response, Some(SetExceptionBreakpointsResponse::default()));
    }
}
