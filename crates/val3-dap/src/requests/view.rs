//! `val3/view`: executes a command of the page that shows the run.

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Map, Value};

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `val3/view`.
pub(crate) enum View {}

impl DebugRequest for View {
    const COMMAND: &'static str = "val3/view";
    type Arguments = ViewArguments;
    type Body = Map<String, Value>;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: ViewArguments,
    ) -> Result<Map<String, Value>, RequestFailure> {
        let ViewArguments { command, arguments } = arguments;
        if ["pace", "cycle"].contains(&command.as_str()) {
            return Err(RequestFailure::DebuggerPaces);
        }
        let operator = &mut session.subscriptions.operator;
        let body = operator.execute(&command, &arguments, &mut run.debugger.controller);
        body.map_err(RequestFailure::rejected)
    }
}

/// Command with its arguments.
#[derive(Debug, Deserialize, JsonSchema)]
pub(crate) struct ViewArguments {
    /// Name of the command.
    command: String,
    /// Arguments of the command.
    #[serde(flatten)]
    arguments: Map<String, Value>,
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn a_page_does_not_pace_a_debugged_run() {
        let mut client = TestClient::stopped(EMPTY);
        let reason = client.failure("val3/view", json!({ "command": "pace", "factor": 1 }));
        assert_eq!(reason, "the debugger stops and continues the run");
        assert!(client.failure("val3/view", json!({})).contains("`command`"));
    }
}
