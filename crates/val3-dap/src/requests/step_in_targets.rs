//! `stepInTargets`: program that the next line of a stack frame calls.

use val3_debug::StepKind;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::inspection::FrameHandle;
use crate::protocol::StepInTarget;
use crate::protocol::{StepInTargetsArguments, StepInTargetsResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `stepInTargets`.
pub(crate) enum StepInTargets {}

impl DebugRequest for StepInTargets {
    const COMMAND: &'static str = "stepInTargets";
    type Arguments = StepInTargetsArguments;
    type Body = StepInTargetsResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: StepInTargetsArguments,
    ) -> Result<StepInTargetsResponse, RequestFailure> {
        let frame = session.handles.frame(arguments.frame_id).ok_or(RequestFailure::Stale)?;
        Ok(StepInTargetsResponse { targets: targets(frame, run) })
    }
}

/// Id of a line's only target.
pub(crate) const TARGET_ID: i32 = 1;

/// Returns the call of the next line. Only the innermost stack frame has a next line.
fn targets(FrameHandle { task, depth }: FrameHandle, run: &DebuggedRun<'_>) -> Vec<StepInTarget> {
    let call = run.debugger.step_in_target(task).filter(|_| depth == 0);
    let target = call.map(|call| {
        let label = format!("{}:{}()", call.application, call.program);
        let label = if call.kind == StepKind::IntoTask { format!("the task of {label}") } else { label };
        StepInTarget { id: TARGET_ID, label, ..StepInTarget::default() }
    });
    target.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{CALLER, EMPTY, MAIN_THREAD, TestClient, WORKER};

    #[test]
    fn a_call_is_a_target_of_the_innermost_stack_frame() {
        let mut client = TestClient::stopped(CALLER);
        let (_, frame) = client.thread_and_frame();
        let expected = json!({ "targets": [{ "id": 1, "label": "main:work()" }] });
        assert_eq!(client.body("stepInTargets", json!({ "frameId": frame })), expected);
        client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD }));
        let trace = client.body("stackTrace", json!({ "threadId": MAIN_THREAD }));
        let caller = json!({ "frameId": trace["stackFrames"][1]["id"] });
        assert_eq!(client.body("stepInTargets", caller), json!({ "targets": [] }));
    }

    #[test]
    fn a_created_task_is_a_target() {
        let mut client = TestClient::stopped(WORKER);
        let (_, frame) = client.thread_and_frame();
        let expected = json!({ "targets": [{ "id": 1, "label": "the task of main:work()" }] });
        assert_eq!(client.body("stepInTargets", json!({ "frameId": frame })), expected);
    }

    #[test]
    fn a_line_without_a_call_has_no_target() {
        let mut client = TestClient::stopped(EMPTY);
        let (_, frame) = client.thread_and_frame();
        assert_eq!(client.body("stepInTargets", json!({ "frameId": frame })), json!({ "targets": [] }));
    }

    #[test]
    fn a_stale_stack_frame_is_rejected() {
        let mut client = TestClient::stopped(EMPTY);
        let reason = client.failure("stepInTargets", json!({ "frameId": 99 }));
        assert_eq!(reason, "this belongs to a stop that is over");
    }
}
