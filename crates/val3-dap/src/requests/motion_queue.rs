//! `val3/motionQueue`: recorded moves that are not done.

use schemars::JsonSchema;
use serde::Serialize;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::moves::QueuedMove;
use crate::request::{DebugRequest, NoArguments};
use crate::session::DebugSession;

/// The request `val3/motionQueue`.
pub(crate) enum MotionQueue {}

impl DebugRequest for MotionQueue {
    const COMMAND: &'static str = "val3/motionQueue";
    type Arguments = NoArguments;
    type Body = MotionQueueBody;

    fn answer(
        _: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        _: NoArguments,
    ) -> Result<MotionQueueBody, RequestFailure> {
        Ok(MotionQueueBody { moves: run.debugger.controller.motion_queue().iter().map(QueuedMove::from).collect() })
    }
}

#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct MotionQueueBody {
    /// Moves in the order of recording.
    moves: Vec<QueuedMove>,
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn no_move_is_recorded_before_the_first_line() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.body("val3/motionQueue", json!({})), json!({ "moves": [] }));
        assert!(client.failure("val3/motionQueue", json!({ "count": 1 })).contains("`count`"));
    }
}
