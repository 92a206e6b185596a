//! `restartFrame`: restarts the program of a stack frame.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{RestartFrameArguments, StoppedEvent, StoppedEventReason};
use crate::request::DebugRequest;
use crate::session::DebugSession;
use crate::stop_event;

/// The request `restartFrame`.
pub(crate) enum RestartFrame {}

impl DebugRequest for RestartFrame {
    const COMMAND: &'static str = "restartFrame";
    type Arguments = RestartFrameArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: RestartFrameArguments,
    ) -> Result<(), RequestFailure> {
        let frame = session.handles.frame(arguments.frame_id).ok_or(RequestFailure::Stale)?;
        let stop = run.debugger.restart_frame(frame.task, frame.depth).map_err(RequestFailure::rejected)?;
        let event = stop_event::stopped(&stop, &mut run.debugger.controller);
        // The specification mentions this reason only in the description of the request.
        let reason = StoppedEventReason::Other("restart".to_owned());
        session.stopped_elsewhere(StoppedEvent { reason, ..event });
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{CALLER, COUNTER, EMPTY, FIRST_LINE, MAIN_THREAD, TestClient};

    #[test]
    fn the_program_is_before_its_first_line_with_the_data_of_that_moment() {
        let mut client = TestClient::stopped(COUNTER);
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(client.value("nCount"), "1");
        let (_, frame) = client.thread_and_frame();
        let stop = client.stop_after("restartFrame", json!({ "frameId": frame }));
        assert_eq!(stop, json!({ "reason": "restart", "threadId": MAIN_THREAD, "allThreadsStopped": true }));
        assert_eq!((client.place().1, client.value("nCount")), (FIRST_LINE, json!("0")));
    }

    #[test]
    fn the_programs_that_a_caller_has_called_are_left() {
        let mut client = TestClient::stopped(CALLER);
        client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD }));
        let trace = client.body("stackTrace", json!({ "threadId": MAIN_THREAD }));
        client.stop_after("restartFrame", json!({ "frameId": trace["stackFrames"][1]["id"] }));
        assert_eq!(client.place(), ("main:start()".to_owned(), FIRST_LINE));
    }

    #[test]
    fn a_stale_stack_frame_is_rejected() {
        let mut client = TestClient::stopped(EMPTY);
        let reason = client.failure("restartFrame", json!({ "frameId": 99 }));
        assert_eq!(reason, "this belongs to a stop that is over");
    }

    #[test]
    fn a_run_of_which_only_a_task_is_stopped_does_not_go_back() {
        let mut client = TestClient::launched(EMPTY, json!({ "stopScope": "task" }));
        client.stop_after("pause", json!({ "threadId": MAIN_THREAD }));
        let (_, frame) = client.thread_and_frame();
        assert_eq!(client.failure("restartFrame", json!({ "frameId": frame })), "notStopped");
    }
}
