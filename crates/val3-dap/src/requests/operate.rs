//! `val3/operate`: executes keys of an `[[at]]` table of a script, without `t`.

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Map, Value};
use val3_machine::controller::Controller;
use val3_machine::script::ScriptAction;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::{DebugRequest, Empty};
use crate::session::DebugSession;

/// The request `val3/operate`.
pub(crate) enum Operate {}

impl DebugRequest for Operate {
    const COMMAND: &'static str = "val3/operate";
    type Arguments = OperateArguments;
    type Body = Empty;

    fn answer(
        _: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: OperateArguments,
    ) -> Result<Empty, RequestFailure> {
        act(arguments.0, &mut run.debugger.controller)
    }
}

/// Keys of an `[[at]]` table.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(transparent)]
pub(crate) struct OperateArguments(Map<String, Value>);

/// Executes an action of the operator or the cell.
///
/// # Errors
/// A key is unknown or has an invalid value, or the controller rejects the action.
pub(super) fn act(keys: Map<String, Value>, controller: &mut Controller) -> Result<Empty, RequestFailure> {
    let action = ScriptAction::from_json(keys).map_err(RequestFailure::rejected)?;
    controller.act(&action).map_err(|problems| RequestFailure::Rejected(problems.join("; ")))?;
    Ok(Empty {})
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn an_unknown_key_is_rejected() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.body("val3/operate", json!({ "power": true })), json!({}));
        let reason = client.failure("val3/operate", json!({ "powr": true }));
        assert!(reason.contains("`powr`"), "{reason}");
    }
}
