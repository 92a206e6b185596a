//! `goto`: continues a task at another line.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::GotoArguments;
use crate::protocol::{StoppedEvent, StoppedEventReason};
use crate::request::DebugRequest;
use crate::session::DebugSession;
use crate::stop_event;

/// The request `goto`.
pub(crate) enum Goto {}

impl DebugRequest for Goto {
    const COMMAND: &'static str = "goto";
    type Arguments = GotoArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: GotoArguments,
    ) -> Result<(), RequestFailure> {
        let task = DebugSession::task(arguments.thread_id, run)?;
        let known = session.goto_targets.get(&arguments.target_id).cloned();
        let (file, row) = known.ok_or(RequestFailure::Stale)?;
        let is_one = session.check_task_stopped(task, run)?;
        let line = run.debugger.goto_target(task, &file, row).map_err(RequestFailure::rejected)?;
        session.report_new_future(run);
        run.debugger.goto(task, line).map_err(RequestFailure::rejected)?;
        let event = stop_event::event(StoppedEventReason::Goto, Some(task));
        session.stopped_elsewhere(StoppedEvent { all_threads_stopped: Some(!is_one), ..event });
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{COUNTER, FIRST_LINE, MAIN_THREAD, TestClient, source};

    /// Returns the id of the target for the second line of the program.
    fn second_line(client: &mut TestClient) -> Value {
        let line = json!({ "source": source("start"), "line": FIRST_LINE + 1 });
        client.body("gotoTargets", line)["targets"][0]["id"].clone()
    }

    #[test]
    fn a_task_continues_at_the_line_without_executing_others() {
        let mut client = TestClient::stopped(COUNTER);
        let target = second_line(&mut client);
        let stop = client.stop_after("goto", json!({ "threadId": MAIN_THREAD, "targetId": target }));
        assert_eq!(stop, json!({ "reason": "goto", "threadId": MAIN_THREAD, "allThreadsStopped": true }));
        assert_eq!(client.place(), ("main:start()".to_owned(), FIRST_LINE + 1));
        assert_eq!(client.value("nCount"), "0");
    }

    #[test]
    fn unknown_tasks_and_targets_are_rejected() {
        let mut client = TestClient::stopped(COUNTER);
        let target = second_line(&mut client);
        let reason = client.failure("goto", json!({ "threadId": 9, "targetId": target }));
        assert_eq!(reason, "there is no such task any more");
        let reason = client.failure("goto", json!({ "threadId": MAIN_THREAD, "targetId": 99 }));
        assert_eq!(reason, "this belongs to a stop that is over");
    }

    #[test]
    fn a_target_is_stale_after_the_run_has_continued() {
        let mut client = TestClient::stopped(COUNTER);
        let target = second_line(&mut client);
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        let reason = client.failure("goto", json!({ "threadId": MAIN_THREAD, "targetId": target }));
        assert_eq!(reason, "this belongs to a stop that is over");
    }

    #[test]
    fn a_running_task_is_not_moved() {
        let mut client = TestClient::launched(COUNTER, json!({}));
        let target = second_line(&mut client);
        assert_eq!(client.failure("goto", json!({ "threadId": MAIN_THREAD, "targetId": target })), "notStopped");
    }
}
