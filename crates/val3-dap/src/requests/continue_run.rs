//! `continue`: resumes all tasks, or one.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{ContinueArguments, ContinueResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `continue`.
pub(crate) enum Continue {}

impl DebugRequest for Continue {
    const COMMAND: &'static str = "continue";
    type Arguments = ContinueArguments;
    type Body = ContinueResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: ContinueArguments,
    ) -> Result<ContinueResponse, RequestFailure> {
        let is_one = session.release(arguments.thread_id, arguments.single_thread, run)?;
        Ok(ContinueResponse { all_threads_continued: Some(!is_one) })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, MAIN_THREAD, TestClient, WORKER, WORKER_THREAD};

    #[test]
    fn a_running_program_cannot_be_resumed() {
        let mut client = TestClient::stopped(EMPTY);
        let expected = json!({ "allThreadsContinued": true });
        assert_eq!(client.body("continue", json!({ "threadId": MAIN_THREAD })), expected);
        assert_eq!(client.failure("continue", json!({ "threadId": MAIN_THREAD })), "notStopped");
    }

    #[test]
    fn a_single_task_continues_while_the_debugger_holds_the_others() {
        let mut client = TestClient::stopped(WORKER);
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        let single = json!({ "threadId": MAIN_THREAD, "singleThread": true });
        assert_eq!(client.body("continue", single), json!({ "allThreadsContinued": false }));
        client.run();
        let worker = json!({ "id": WORKER_THREAD, "name": "worker (priority 10, held by the debugger)" });
        assert_eq!(client.body("threads", json!({})), json!({ "threads": [worker] }));
    }

    #[test]
    fn an_unknown_task_does_not_continue_alone() {
        let mut client = TestClient::stopped(EMPTY);
        let single = json!({ "threadId": 9, "singleThread": true });
        assert_eq!(client.failure("continue", single), "there is no such task any more");
    }
}
