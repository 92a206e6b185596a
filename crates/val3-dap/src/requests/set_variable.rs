//! `setVariable`: assigns a value to a variable of a scope or a value.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::inspection::Node;
use crate::protocol::{SetVariableArguments, SetVariableResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `setVariable`.
pub(crate) enum SetVariable {}

impl DebugRequest for SetVariable {
    const COMMAND: &'static str = "setVariable";
    type Arguments = SetVariableArguments;
    type Body = SetVariableResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SetVariableArguments,
    ) -> Result<SetVariableResponse, RequestFailure> {
        let inside = match session.handles.node(arguments.variables_reference).ok_or(RequestFailure::Stale)? {
            Node::Values(inside) => inside.clone(),
            Node::Properties(_) => return Err(RequestFailure::NoData(arguments.name)),
        };
        let assignment = (arguments.name.as_str(), arguments.value.as_str());
        let format = session.format(arguments.format.as_ref());
        let value = run.evaluator.assign_child(&mut run.debugger.controller, &inside, assignment, format);
        let value = value.map_err(RequestFailure::rejected)?;
        let variable = session.shown(value, run);
        Ok(SetVariableResponse {
            value: variable.value,
            r#type: variable.r#type,
            variables_reference: Some(variable.variables_reference),
            indexed_variables: variable.indexed_variables,
            named_variables: variable.named_variables,
            ..SetVariableResponse::default()
        })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{COUNTER, TestClient};

    fn assignment(scope: &Value, name: &str, value: &str) -> Value {
        json!({ "variablesReference": scope, "name": name, "value": value })
    }

    #[test]
    fn a_variable_has_the_value_of_the_expression() {
        let mut client = TestClient::stopped(COUNTER);
        let globals = client.scope("Globals");
        let expected = json!({ "value": "5", "type": "num", "variablesReference": 0 });
        assert_eq!(client.body("setVariable", assignment(&globals, "nCount", "2+3")), expected);
        assert_eq!(client.value("nCount"), "5");
    }

    #[test]
    fn a_value_of_another_type_is_rejected() {
        let mut client = TestClient::stopped(COUNTER);
        let globals = client.scope("Globals");
        assert_eq!(
            client.failure("setVariable", assignment(&globals, "nCount", "true")),
            "a `bool` cannot be assigned to a `num`"
        );
        assert_eq!(client.value("nCount"), "0");
    }

    #[test]
    fn a_property_of_the_cell_is_not_assigned() {
        let mut client = TestClient::stopped(COUNTER);
        let robot = client.scope("Robot");
        let reason = client.failure("setVariable", assignment(&robot, "power", "on"));
        assert_eq!(reason, "`power` is not data of a program; use `val3/operate`");
    }

    #[test]
    fn a_stale_handle_is_rejected() {
        let mut client = TestClient::stopped(COUNTER);
        let reason = client.failure("setVariable", assignment(&json!(99), "nCount", "1"));
        assert_eq!(reason, "this belongs to a stop that is over");
    }
}
