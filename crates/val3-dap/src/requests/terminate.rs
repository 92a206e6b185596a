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
        run.debugger.controller.operate(OperatorAction::Stop);
        run.debugger.resume_tasks();
        session.run_on();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::session::NextAction;
    use crate::test_client::{EMPTY, FIRST_LINE, TestClient};

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
