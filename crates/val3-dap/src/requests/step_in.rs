//! `stepIn`: executes a line up to its first call.

use val3_debug::StepKind;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::StepInArguments;
use crate::request::DebugRequest;
use crate::requests::step_in_targets::TARGET_ID;
use crate::session::DebugSession;

/// The request `stepIn`.
pub(crate) enum StepIn {}

impl DebugRequest for StepIn {
    const COMMAND: &'static str = "stepIn";
    type Arguments = StepInArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: StepInArguments,
    ) -> Result<(), RequestFailure> {
        let task = DebugSession::task(arguments.thread_id, run)?;
        let StepInArguments { thread_id, single_thread, target_id, .. } = arguments;
        let Some(id) = target_id else { return session.step(thread_id, single_thread, StepKind::In, run) };
        let target = run.debugger.step_in_target(task).filter(|_| id == TARGET_ID);
        let target = target.ok_or(RequestFailure::NoStepInTarget(id))?;
        session.step(thread_id, single_thread, target.kind, run)?;
        run.debugger.step_into(task, &target);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{CALLER, COUNTER, EMPTY, FIRST_LINE, MAIN_THREAD, TestClient, WORKER, WORKER_THREAD};

    #[test]
    fn a_call_stops_in_the_called_program() {
        let mut client = TestClient::stopped(CALLER);
        let stop = client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop, json!({ "reason": "step", "threadId": MAIN_THREAD, "allThreadsStopped": true }));
        assert_eq!(client.place(), ("main:work()".to_owned(), FIRST_LINE));
    }

    #[test]
    fn a_line_without_a_call_is_executed() {
        let mut client = TestClient::stopped(COUNTER);
        client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD }));
        assert_eq!((client.place().1, client.value("nCount")), (FIRST_LINE + 1, json!("1")));
    }

    #[test]
    fn the_target_of_a_created_task_stops_in_the_new_task() {
        let mut client = TestClient::stopped(WORKER);
        let stop = client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD, "targetId": 1 }));
        assert_eq!(stop, json!({ "reason": "step", "threadId": WORKER_THREAD, "allThreadsStopped": true }));
    }

    #[test]
    fn skipped_programs_are_stepped_over() {
        for (pattern, place) in [("main:w*", ("main:start()", FIRST_LINE + 1)), ("other", ("main:work()", FIRST_LINE))]
        {
            let mut client = TestClient::launching(CALLER, json!({ "stopOnEntry": true, "skip": [pattern] }));
            client.body("configurationDone", json!({}));
            client.run();
            client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD }));
            assert_eq!(client.place(), (place.0.to_owned(), place.1), "{pattern}");
        }
    }

    #[test]
    fn a_chosen_target_is_not_skipped() {
        let mut client = TestClient::launching(CALLER, json!({ "stopOnEntry": true, "skip": ["main:w*"] }));
        client.body("configurationDone", json!({}));
        client.run();
        client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD, "targetId": 1 }));
        assert_eq!(client.place(), ("main:work()".to_owned(), FIRST_LINE));
    }

    #[test]
    fn unknown_targets_are_rejected() {
        let mut client = TestClient::stopped(WORKER);
        let failure = client.failure("stepIn", json!({ "threadId": MAIN_THREAD, "targetId": 7 }));
        assert_eq!(failure, "the next line has no step-in target 7: request `stepInTargets` again");
        let mut client = TestClient::stopped(COUNTER);
        let failure = client.failure("stepIn", json!({ "threadId": MAIN_THREAD, "targetId": 1 }));
        assert_eq!(failure, "the next line has no step-in target 1: request `stepInTargets` again");
    }

    #[test]
    fn unknown_and_running_tasks_are_rejected() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.failure("stepIn", json!({ "threadId": 9 })), "there is no such task any more");
        let mut client = TestClient::launched(EMPTY, json!({}));
        assert_eq!(client.failure("stepIn", json!({ "threadId": MAIN_THREAD })), "notStopped");
    }
}
