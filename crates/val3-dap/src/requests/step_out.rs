//! `stepOut`: executes the rest of a program.

use val3_debug::StepKind;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::StepOutArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `stepOut`.
pub(crate) enum StepOut {}

impl DebugRequest for StepOut {
    const COMMAND: &'static str = "stepOut";
    type Arguments = StepOutArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: StepOutArguments,
    ) -> Result<(), RequestFailure> {
        session.step(arguments.thread_id, arguments.single_thread, StepKind::Out, run)
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{CALLER, EMPTY, FIRST_LINE, MAIN_THREAD, TestClient};

    #[test]
    fn the_rest_of_the_program_is_executed() {
        let mut client = TestClient::stopped(CALLER);
        client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD }));
        let stop = client.stop_after("stepOut", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop, json!({ "reason": "step", "threadId": MAIN_THREAD, "allThreadsStopped": true }));
        assert_eq!(client.place(), ("main:start()".to_owned(), FIRST_LINE + 1));
    }

    #[test]
    fn the_first_program_of_a_task_ends_without_a_stop() {
        let mut client = TestClient::stopped(EMPTY);
        client.body("stepOut", json!({ "threadId": MAIN_THREAD }));
        let events = client.run();
        assert_eq!(events, [("thread".to_owned(), json!({ "reason": "exited", "threadId": MAIN_THREAD }))]);
    }

    #[test]
    fn unknown_and_running_tasks_are_rejected() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.failure("stepOut", json!({ "threadId": 9 })), "there is no such task any more");
        let mut client = TestClient::launched(EMPTY, json!({}));
        assert_eq!(client.failure("stepOut", json!({ "threadId": MAIN_THREAD })), "notStopped");
    }
}
