//! `val3/motionMode`: returns the motion mode, after changing it if `mode` is set.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use val3_machine::arm::MotionMode;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `val3/motionMode`.
pub(crate) enum MotionModeRequest {}

impl DebugRequest for MotionModeRequest {
    const COMMAND: &'static str = "val3/motionMode";
    type Arguments = MotionModeArguments;
    type Body = MotionModeBody;

    fn answer(
        _: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: MotionModeArguments,
    ) -> Result<MotionModeBody, RequestFailure> {
        if let Some(mode) = arguments.mode {
            run.debugger.set_motion_mode(mode.into());
        }
        Ok(MotionModeBody { mode: run.debugger.motion_mode().into() })
    }
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct MotionModeArguments {
    /// New motion mode.
    mode: Option<MotionModeName>,
}

#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct MotionModeBody {
    /// Present motion mode.
    mode: MotionModeName,
}

/// Motion mode (10.2.2).
#[derive(Debug, Clone, Copy, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) enum MotionModeName {
    /// The arm follows its path without a stop.
    Continuous,
    /// The arm stops at the end of each piece of the motion.
    Step,
}

impl From<MotionModeName> for MotionMode {
    fn from(name: MotionModeName) -> Self {
        match name {
            MotionModeName::Continuous => Self::Continuous,
            MotionModeName::Step => Self::Step,
        }
    }
}

impl From<MotionMode> for MotionModeName {
    fn from(mode: MotionMode) -> Self {
        match mode {
            MotionMode::Continuous => Self::Continuous,
            MotionMode::Step => Self::Step,
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn the_mode_changes() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.body("val3/motionMode", json!({})), json!({ "mode": "continuous" }));
        assert_eq!(client.body("val3/motionMode", json!({ "mode": "step" })), json!({ "mode": "step" }));
        let reason = client.failure("val3/motionMode", json!({ "mode": "fast" }));
        assert!(reason.contains("`fast`"), "{reason}");
    }
}
