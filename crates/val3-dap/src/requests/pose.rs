//! `val3/pose`: position and motion of the arm.

use val3_machine::event::seconds;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::moves::ArmSample;
use crate::request::{DebugRequest, NoArguments};
use crate::session::DebugSession;

/// The request `val3/pose`.
pub(crate) enum Pose {}

impl DebugRequest for Pose {
    const COMMAND: &'static str = "val3/pose";
    type Arguments = NoArguments;
    type Body = ArmSample;

    fn answer(_: &mut DebugSession, run: &mut DebuggedRun<'_>, _: NoArguments) -> Result<ArmSample, RequestFailure> {
        let controller = &run.debugger.controller;
        Ok(ArmSample::new(seconds(controller.now()), controller))
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn the_pose_has_six_coordinates() {
        let mut client = TestClient::stopped(EMPTY);
        let pose = client.body("val3/pose", json!({}));
        assert_eq!(pose["pose"].as_array().unwrap().len(), 6);
        assert_eq!((&pose["t"], &pose["source"]), (&json!(0.0), &Value::Null));
    }
}
