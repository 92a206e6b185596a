//! `setBreakpoints`: replaces the breakpoints of a file.

use crate::breakpoint_hits::BreakpointGroup;
use crate::breakpoints;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{SetBreakpointsArguments, SetBreakpointsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `setBreakpoints`.
pub(crate) enum SetBreakpoints {}

impl DebugRequest for SetBreakpoints {
    const COMMAND: &'static str = "setBreakpoints";
    type Arguments = SetBreakpointsArguments;
    type Body = SetBreakpointsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SetBreakpointsArguments,
    ) -> Result<SetBreakpointsResponse, RequestFailure> {
        let group = BreakpointGroup::File(arguments.source.path.clone().unwrap_or_default());
        let mut breakpoints = session.breakpoints.set(arguments, run, &session.conventions);
        session.shown_hits.replace(group, &mut breakpoints, run.debugger);
        Ok(SetBreakpointsResponse { breakpoints })
    }

    fn in_plain_run(arguments: &SetBreakpointsArguments) -> Option<SetBreakpointsResponse> {
        let SetBreakpointsArguments { breakpoints, lines, .. } = arguments;
        let count = breakpoints.as_ref().map(Vec::len).or(lines.as_ref().map(Vec::len)).unwrap_or_default();
        Some(SetBreakpointsResponse { breakpoints: breakpoints::ignored(count) })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;
    use crate::test_client::{COUNTER, FIRST_LINE, MAIN_THREAD, TestClient, source};

    fn set(client: &mut TestClient, file: &str, breakpoint: Value) -> Value {
        let arguments = json!({ "source": source(file), "breakpoints": [breakpoint] });
        client.body("setBreakpoints", arguments)["breakpoints"][0].clone()
    }

    #[test]
    fn a_breakpoint_moves_to_the_next_line_with_an_instruction() {
        let mut client = TestClient::stopped(COUNTER);
        let expected = json!({ "id": 1, "verified": true, "line": FIRST_LINE, "source": source("start") });
        assert_eq!(set(&mut client, "start", json!({ "line": 1 })), expected);
    }

    #[test]
    fn a_line_with_a_breakpoint_stops_the_run() {
        let mut client = TestClient::stopped(COUNTER);
        set(&mut client, "start", json!({ "line": FIRST_LINE + 1, "condition": "nCount==1" }));
        let expected = json!({
            "reason": "breakpoint",
            "threadId": MAIN_THREAD,
            "allThreadsStopped": true,
            "hitBreakpointIds": [1],
        });
        assert_eq!(client.stop_after("continue", json!({ "threadId": MAIN_THREAD })), expected);
        assert_eq!(client.place().1, FIRST_LINE + 1);
    }

    #[test]
    fn only_an_unchanged_breakpoint_keeps_its_id() {
        let mut client = TestClient::stopped(COUNTER);
        let mut id = |line| set(&mut client, "start", json!({ "line": line }))["id"].clone();
        assert_eq!([id(FIRST_LINE), id(FIRST_LINE), id(FIRST_LINE + 1)], [1, 1, 2]);
    }

    #[test]
    fn a_file_may_be_loaded_later() {
        let mut client = TestClient::stopped(COUNTER);
        let expected = json!({
            "id": 1,
            "verified": false,
            "message": "the application has loaded no program of this file yet",
            "reason": "pending",
        });
        assert_eq!(set(&mut client, "other", json!({ "line": 1 })), expected);
    }

    #[test]
    fn unusable_breakpoints_are_not_verified() {
        let mut client = TestClient::stopped(COUNTER);
        let mut message = |breakpoint| set(&mut client, "start", breakpoint)["message"].clone();
        assert_eq!(message(json!({ "line": 99 })), "no instruction follows this line");
        let condition = json!({ "line": FIRST_LINE, "condition": "nOther>1" });
        assert_eq!(message(condition), "`nOther` is not declared: no local variable, parameter or data has this name");
        let hits = json!({ "line": FIRST_LINE, "hitCondition": "often" });
        assert_eq!(message(hits), "write a number of hits such as 5, >5, >=5, <5, <=5 or %5");
    }

    #[test]
    fn a_run_without_debugging_ignores_breakpoints() {
        let arguments = SetBreakpointsArguments { lines: Some(vec![1, 2]), ..SetBreakpointsArguments::default() };
        let response = SetBreakpoints::in_plain_run(&arguments).unwrap();
        let messages = response.breakpoints.iter().map(|breakpoint| breakpoint.message.as_deref());
        assert_eq!(messages.collect::<Vec<_>>(), [Some("the run is not debugged"); 2]);
    }

    /// Blocks of each kind, from line 5 to 18 of the file.
    const BLOCKS: &str = "\
num nAt
num nCount

program start()
begin
  for nAt=1 to 2
    switch nAt
      case 1
        nCount=1
      break
      default
        nCount=2
      break
    endSwitch
  endFor
  while nCount<4
    nCount=nCount+1
  endWhile
end
";

    #[test]
    fn a_task_stops_where_control_passes_the_end_of_a_block() {
        let mut client = TestClient::stopped(BLOCKS);
        let locations = json!({ "source": source("start"), "line": 5, "endLine": 18 });
        let locations = client.body("breakpointLocations", locations)["breakpoints"].clone();
        let lines: Vec<_> = locations.as_array().unwrap().iter().map(|found| found["line"].as_u64().unwrap()).collect();
        assert_eq!(lines, [5, 6, 8, 9, 11, 12, 14, 15, 16, 17, 18]);
        let wanted = [9, 14, 17, 18];
        let breakpoints = wanted.map(|line| json!({ "line": line }));
        let set = client.body("setBreakpoints", json!({ "source": source("start"), "breakpoints": breakpoints }));
        let placed = set["breakpoints"].as_array().unwrap().iter().map(|found| found["line"].as_u64().unwrap());
        assert_eq!(placed.collect::<Vec<_>>(), wanted);
        let mut stops = Vec::new();
        for _ in 0..6 {
            assert_eq!(client.stop_after("continue", json!({ "threadId": MAIN_THREAD }))["reason"], "breakpoint");
            stops.push(client.place().1);
        }
        assert_eq!(stops, [9, 14, 14, 17, 17, 18]);
        assert_eq!(client.value("nCount"), "4");
        let back = client.stop_after("reverseContinue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!((&back["reason"], client.place().1), (&json!("breakpoint"), 17));
        client.body("setBreakpoints", json!({ "source": source("start"), "breakpoints": [] }));
        client.body("continue", json!({ "threadId": MAIN_THREAD }));
        assert!(client.run().iter().all(|(event, _)| event != "stopped"));
    }
}
