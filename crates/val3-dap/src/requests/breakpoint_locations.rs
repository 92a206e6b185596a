//! `breakpointLocations`: lines of a file that can have breakpoints.

use crate::breakpoints;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{BreakpointLocationsArguments, BreakpointLocationsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `breakpointLocations`.
pub(crate) enum BreakpointLocations {}

impl DebugRequest for BreakpointLocations {
    const COMMAND: &'static str = "breakpointLocations";
    type Arguments = BreakpointLocationsArguments;
    type Body = BreakpointLocationsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: BreakpointLocationsArguments,
    ) -> Result<BreakpointLocationsResponse, RequestFailure> {
        let breakpoints = breakpoints::locations(&arguments, &run.debugger.controller, &session.conventions);
        Ok(BreakpointLocationsResponse { breakpoints })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{COUNTER, FIRST_LINE, TestClient, source};

    #[test]
    fn lines_with_instructions_are_returned() {
        let mut client = TestClient::stopped(COUNTER);
        let range = json!({ "source": source("start"), "line": 1, "endLine": FIRST_LINE + 1 });
        let expected = json!({ "breakpoints": [{ "line": FIRST_LINE }, { "line": FIRST_LINE + 1 }] });
        assert_eq!(client.body("breakpointLocations", range), expected);
    }

    #[test]
    fn without_an_end_the_range_is_one_line() {
        let mut client = TestClient::stopped(COUNTER);
        let line = json!({ "source": source("start"), "line": FIRST_LINE });
        assert_eq!(client.body("breakpointLocations", line), json!({ "breakpoints": [{ "line": FIRST_LINE }] }));
        let head = json!({ "source": source("start"), "line": FIRST_LINE - 1 });
        assert_eq!(client.body("breakpointLocations", head), json!({ "breakpoints": [] }));
    }

    #[test]
    fn lines_begin_with_0_if_the_client_counts_so() {
        let mut client = TestClient::stopped(COUNTER).counting_from_0();
        let line = json!({ "source": source("start"), "line": FIRST_LINE - 1 });
        assert_eq!(client.body("breakpointLocations", line), json!({ "breakpoints": [{ "line": FIRST_LINE - 1 }] }));
    }

    #[test]
    fn a_file_that_is_not_loaded_has_no_lines() {
        let mut client = TestClient::stopped(COUNTER);
        let range = json!({ "source": source("other"), "line": 1, "endLine": 99 });
        assert_eq!(client.body("breakpointLocations", range), json!({ "breakpoints": [] }));
    }

    #[test]
    fn a_source_is_required() {
        let mut client = TestClient::stopped(COUNTER);
        assert_eq!(
            client.failure("breakpointLocations", json!({ "line": 1 })),
            "the arguments of `breakpointLocations` are wrong: missing field `source`"
        );
    }
}
