//! `next`: executes a line, with its calls.

use val3_debug::StepKind;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::NextArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `next`.
pub(crate) enum Next {}

impl DebugRequest for Next {
    const COMMAND: &'static str = "next";
    type Arguments = NextArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: NextArguments,
    ) -> Result<(), RequestFailure> {
        session.step(arguments.thread_id, arguments.single_thread, StepKind::Over, run)
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{CALLER, EMPTY, FIRST_LINE, MAIN_THREAD, TestClient};

    #[test]
    fn a_call_is_executed_with_its_line() {
        let mut client = TestClient::stopped(CALLER);
        let stop = client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop, json!({ "reason": "step", "threadId": MAIN_THREAD, "allThreadsStopped": true }));
        assert_eq!(client.place(), ("main:start()".to_owned(), FIRST_LINE + 1));
    }

    #[test]
    fn an_unknown_task_is_rejected() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.failure("next", json!({ "threadId": 9 })), "there is no such task any more");
    }

    #[test]
    fn a_running_task_is_not_stepped() {
        let mut client = TestClient::launched(EMPTY, json!({}));
        assert_eq!(client.failure("next", json!({ "threadId": MAIN_THREAD })), "notStopped");
    }
}
