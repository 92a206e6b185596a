//! `terminate`: runs the program `stop`, as when an operator stops the application.

use val3_machine::controller::OperatorAction;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::TerminateArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `terminate`.
pub(crate) enum Terminate {}

impl DebugRequest for Terminate {
    const COMMAND: &'static str = "terminate";
    type Arguments = TerminateArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        _: TerminateArguments,
    ) -> Result<(), RequestFailure> {
        session.report_new_future(run);
        run.debugger.controller.operate(OperatorAction::Stop);
        run.debugger.begin_new_future();
        run.debugger.resume_tasks();
        session.run_on();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::session::NextAction;
    use crate::test_client::{EMPTY, FIRST_LINE, MAIN_THREAD, TestClient, source};

    const STOPPABLE: &str = "\
program start()
begin
  delay(1)
end

program stop()
begin
  delay(1)
end
";

    #[test]
    fn a_stopped_run_executes_the_program_stop() {
        let mut client = TestClient::stopped(STOPPABLE);
        client.body("setFunctionBreakpoints", json!({ "breakpoints": [{ "name": "stop" }] }));
        let stop = client.stop_after("terminate", json!({}));
        assert_eq!((&stop["reason"], &stop["hitBreakpointIds"]), (&json!("breakpoint"), &json!([1])));
        assert_eq!(client.place(), ("main:stop()".to_owned(), FIRST_LINE));
    }

    const LINES: &str = "num nCount\n\nprogram start()\nbegin\n  nCount=1\n  nCount=2\n  nCount=3\n  delay(1)\nend\n\n\
                         program stop()\nbegin\n  nCount=9\nend\n";

    fn lines(client: &mut TestClient, lines: &[i64]) {
        let breakpoints: Vec<_> = lines.iter().map(|line| json!({ "line": line })).collect();
        client.body("setBreakpoints", json!({ "source": source("start"), "breakpoints": breakpoints }));
    }

    /// The application stops at the end of the cycle. Before that, its tasks reach further lines.
    #[test]
    fn further_breakpoints_of_the_cycle_do_not_stop_the_run() {
        for (options, count) in
            [(json!({}), "3"), (json!({ "stopOnExit": true }), "3"), (json!({ "stopScope": "task" }), "1")]
        {
            let mut client = TestClient::launching(LINES, options);
            lines(&mut client, &[5, 6, 7]);
            client.body("configurationDone", json!({}));
            client.run();
            assert_eq!(client.place().1, 5);
            client.body("setFunctionBreakpoints", json!({ "breakpoints": [{ "name": "stop" }] }));
            client.stop_after("terminate", json!({}));
            assert_eq!((client.place().0, client.value("nCount")), ("main:stop()".to_owned(), json!(count)));
        }
    }

    /// A replay stops where the run has stopped, and a new `terminate` replaces the recorded one.
    #[test]
    fn a_run_that_has_gone_back_stops_at_its_breakpoints_and_ends_by_another_request() {
        let mut client = TestClient::launching(LINES, json!({}));
        lines(&mut client, &[5, 6, 8]);
        client.body("configurationDone", json!({}));
        client.run();
        client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        client.body("setFunctionBreakpoints", json!({ "breakpoints": [{ "name": "stop" }] }));
        let stop = client.stop_after("terminate", json!({}));
        for line in [8, 6, 5] {
            client.stop_after("reverseContinue", json!({ "threadId": stop["threadId"] }));
            assert_eq!(client.place().1, line);
        }
        client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(client.place().1, 6);
        client.stop_after("terminate", json!({}));
        assert_eq!((client.place().0, client.value("nCount")), ("main:stop()".to_owned(), json!("3")));
    }

    #[test]
    fn a_run_ends_after_the_program_stop() {
        let mut client = TestClient::stopped(STOPPABLE);
        assert_eq!(client.action("terminate", json!({})), NextAction::Run);
        client.run();
        assert_eq!(client.body("threads", json!({})), json!({ "threads": [] }));
    }

    #[test]
    fn handles_are_stale_because_the_run_continues() {
        let mut client = TestClient::stopped(EMPTY);
        let (_, frame) = client.thread_and_frame();
        client.body("terminate", json!({}));
        let reason = client.failure("scopes", json!({ "frameId": frame }));
        assert_eq!(reason, "this belongs to a stop that is over");
    }
}
