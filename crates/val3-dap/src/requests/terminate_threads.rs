//! `terminateThreads`: kills tasks. If one of them does not exist, none is killed.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::TerminateThreadsArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `terminateThreads`.
pub(crate) enum TerminateThreads {}

impl DebugRequest for TerminateThreads {
    const COMMAND: &'static str = "terminateThreads";
    type Arguments = TerminateThreadsArguments;
    type Body = ();

    fn answer(
        _: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: TerminateThreadsArguments,
    ) -> Result<(), RequestFailure> {
        let threads = arguments.thread_ids.unwrap_or_default();
        let tasks = threads.into_iter().map(|thread| DebugSession::task(thread, run));
        let tasks = tasks.collect::<Result<Vec<_>, RequestFailure>>()?;
        tasks.into_iter().for_each(|task| run.debugger.controller.kill(task));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{MAIN_THREAD, TestClient, WORKER, WORKER_THREAD};

    fn threads(client: &mut TestClient) -> Vec<Value> {
        let threads = client.body("threads", json!({}))["threads"].clone();
        threads.as_array().unwrap().iter().map(|thread| thread["id"].clone()).collect()
    }

    /// Returns the client of a run with two tasks.
    fn client() -> TestClient {
        let mut client = TestClient::stopped(WORKER);
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        client
    }

    #[test]
    fn only_the_tasks_are_killed() {
        let mut client = client();
        assert_eq!(threads(&mut client), [MAIN_THREAD, WORKER_THREAD]);
        let events = client.events("terminateThreads", json!({ "threadIds": [WORKER_THREAD] }));
        assert_eq!(events, [("thread".to_owned(), json!({ "reason": "exited", "threadId": WORKER_THREAD }))]);
        assert_eq!(threads(&mut client), [MAIN_THREAD]);
    }

    #[test]
    fn no_task_is_killed_if_one_does_not_exist() {
        let mut client = client();
        let reason = client.failure("terminateThreads", json!({ "threadIds": [WORKER_THREAD, 9] }));
        assert_eq!(reason, "there is no such task any more");
        assert_eq!(threads(&mut client), [MAIN_THREAD, WORKER_THREAD]);
    }

    #[test]
    fn without_ids_no_task_is_killed() {
        let mut client = client();
        client.body("terminateThreads", json!({}));
        assert_eq!(threads(&mut client), [MAIN_THREAD, WORKER_THREAD]);
    }
}
