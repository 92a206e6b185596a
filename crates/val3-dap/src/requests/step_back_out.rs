//! `val3/stepBackOut`: returns to the line that has called the present program.

use val3_debug::StepKind;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::{DebugRequest, Empty, ThreadArguments};
use crate::session::DebugSession;

/// The request `val3/stepBackOut`.
pub(crate) enum StepBackOut {}

impl DebugRequest for StepBackOut {
    const COMMAND: &'static str = "val3/stepBackOut";
    type Arguments = ThreadArguments;
    type Body = Empty;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: ThreadArguments,
    ) -> Result<Empty, RequestFailure> {
        session.step_back(arguments.thread_id, StepKind::Out, run).map(|()| Empty {})
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, MAIN_THREAD, TestClient};

    #[test]
    fn the_first_program_of_a_task_has_no_caller() {
        let mut client = TestClient::stopped(EMPTY);
        let stop = client.stop_after("val3/stepBackOut", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(stop["description"], "Paused at the beginning of the recorded past");
        assert!(client.failure("val3/stepBackOut", json!({ "thread": 2 })).contains("`thread`"));
    }
}
