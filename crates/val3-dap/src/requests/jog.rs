//! `val3/jog`: moves the arm by hand.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::{DebugRequest, Empty};
use crate::requests::operate;
use crate::session::DebugSession;

/// The request `val3/jog`.
pub(crate) enum Jog {}

impl DebugRequest for Jog {
    const COMMAND: &'static str = "val3/jog";
    type Arguments = JogArguments;
    type Body = Empty;

    fn answer(
        _: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: JogArguments,
    ) -> Result<Empty, RequestFailure> {
        let keys = [("jog".to_owned(), arguments.joints.into())].into_iter().collect();
        operate::act(keys, &mut run.debugger.controller)
    }
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct JogArguments {
    /// Joint position, in degrees (linear axes: mm).
    joints: Vec<f64>,
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn joints_are_numbers() {
        let mut client = TestClient::stopped(EMPTY);
        let reason = client.failure("val3/jog", json!({ "joints": "home" }));
        assert!(reason.contains("`joints`"), "{reason}");
    }
}
