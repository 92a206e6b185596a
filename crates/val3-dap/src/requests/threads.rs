//! `threads`: tasks of the controller.

use serde::de::IgnoredAny;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::inspection;
use crate::protocol::ThreadsResponse;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `threads`.
pub(crate) enum Threads {}

impl DebugRequest for Threads {
    const COMMAND: &'static str = "threads";
    type Arguments = IgnoredAny;
    type Body = ThreadsResponse;

    fn answer(
        _: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        _: IgnoredAny,
    ) -> Result<ThreadsResponse, RequestFailure> {
        Ok(ThreadsResponse { threads: inspection::threads(&run.debugger.controller) })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{EMPTY, MAIN_THREAD, TestClient, WORKER, WORKER_THREAD};

    #[test]
    fn each_task_is_a_thread_with_its_priority() {
        let mut client = TestClient::stopped(WORKER);
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        let expected = json!({ "threads": [
            { "id": MAIN_THREAD, "name": "main~ (priority 10)" },
            { "id": WORKER_THREAD, "name": "worker (priority 10)" },
        ] });
        assert_eq!(client.body("threads", json!({})), expected);
    }

    #[test]
    fn a_run_without_tasks_has_no_threads() {
        let mut client = TestClient::launched(EMPTY, json!({}));
        client.run();
        assert_eq!(client.body("threads", json!({})), json!({ "threads": [] }));
    }

    #[test]
    fn a_task_that_an_error_has_stopped_is_named_with_the_error() {
        let mut client = TestClient::launched("program start()\nbegin\n  delay(1/0)\nend\n", json!({}));
        client.run();
        let thread = json!({ "id": MAIN_THREAD, "name": "main~ (priority 10, error 10: division by zero)" });
        assert_eq!(client.body("threads", json!({})), json!({ "threads": [thread] }));
    }

    #[test]
    fn any_arguments_are_ignored() {
        let mut client = TestClient::stopped(EMPTY);
        for arguments in [Value::Null, json!({}), json!({ "threadId": "main" })] {
            let threads = client.body("threads", arguments);
            assert_eq!(threads, json!({ "threads": [{ "id": MAIN_THREAD, "name": "main~ (priority 10)" }] }));
        }
    }
}
