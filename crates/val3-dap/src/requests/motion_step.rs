//! `val3/motionStep`: executes one piece of the motion in step mode; `stopped` is sent on arrival.

use schemars::JsonSchema;
use serde::Serialize;
use val3_machine::arm::MotionMode;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::moves::MovePiece;
use crate::request::{DebugRequest, NoArguments};
use crate::session::DebugSession;

/// The request `val3/motionStep`.
pub(crate) enum MotionStep {}

impl DebugRequest for MotionStep {
    const COMMAND: &'static str = "val3/motionStep";
    type Arguments = NoArguments;
    type Body = MotionStepBody;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        _: NoArguments,
    ) -> Result<MotionStepBody, RequestFailure> {
        if run.debugger.motion_mode() != MotionMode::Step {
            return Err(RequestFailure::NoStepMode);
        }
        let next = run.debugger.controller.motion_status().next.ok_or(RequestFailure::NoMotion)?;
        run.debugger.step_motion();
        session.run_on();
        Ok(MotionStepBody { piece: MovePiece::from(&next) })
    }
}

#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct MotionStepBody {
    /// Piece that is executed.
    piece: MovePiece,
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn a_step_needs_step_mode_and_a_move() {
        let mut client = TestClient::stopped(EMPTY);
        assert!(client.failure("val3/motionStep", json!({})).contains("not in step mode"));
        client.body("val3/motionMode", json!({ "mode": "step" }));
        assert!(client.failure("val3/motionStep", json!({})).contains("no further motion"));
    }

    #[test]
    fn a_running_program_is_not_stepped() {
        let mut client = TestClient::launched(EMPTY, json!({ "motionMode": "step" }));
        assert_eq!(client.failure("val3/motionStep", json!({})), "notStopped");
    }
}
