//! `setExpression`: assigns a value to an expression.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{SetExpressionArguments, SetExpressionResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `setExpression`.
pub(crate) enum SetExpression {}

impl DebugRequest for SetExpression {
    const COMMAND: &'static str = "setExpression";
    type Arguments = SetExpressionArguments;
    type Body = SetExpressionResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SetExpressionArguments,
    ) -> Result<SetExpressionResponse, RequestFailure> {
        let context = session.context(arguments.frame_id, run)?;
        let (target, value) = (&arguments.expression, &arguments.value);
        let format = session.format(arguments.format.as_ref());
        let value = run.evaluator.assign(&mut run.debugger.controller, context, target, value, format);
        let value = value.map_err(RequestFailure::rejected)?;
        let variable = session.shown(value, run);
        Ok(SetExpressionResponse {
            value: variable.value,
            r#type: variable.r#type,
            variables_reference: Some(variable.variables_reference),
            indexed_variables: variable.indexed_variables,
            named_variables: variable.named_variables,
            ..SetExpressionResponse::default()
        })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{COUNTER, INPUT, MAIN_THREAD, TestClient};

    #[test]
    fn a_variable_of_an_input_forces_it() {
        let mut client = TestClient::stopped(INPUT);
        let (_, frame) = client.thread_and_frame();
        let arguments = json!({ "expression": "diIn", "value": "true", "frameId": frame });
        assert!(client.body("setExpression", arguments)["value"].as_str().unwrap().starts_with("true"));
        assert_eq!(client.body("val3/io", json!({}))["signals"][0]["value"], 1.0);
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(client.value("nCount"), "1");
    }

    #[test]
    fn data_get_a_value() {
        let mut client = TestClient::stopped(COUNTER);
        let (_, frame) = client.thread_and_frame();
        let arguments = json!({ "expression": "nCount", "value": "3", "frameId": frame });
        assert_eq!(client.body("setExpression", arguments)["value"], "3");
    }
}
