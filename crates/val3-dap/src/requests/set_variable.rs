//! `setVariable`: assigns a value to a variable of a scope or a value.

use crate::cell_view;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::inspection::InspectedItem;
use crate::protocol::{SetVariableArguments, SetVariableResponse};
use crate::request::DebugRequest;
use crate::requests::io_force;
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
            InspectedItem::Values(inside) => inside.clone(),
            InspectedItem::Libraries(_) => return Err(RequestFailure::NoData(arguments.name)),
            InspectedItem::Properties(properties) => {
                let signal = properties.iter().find(|property| property.name == arguments.name);
                let signal = signal.and_then(|property| property.signal.clone());
                let signal = signal.ok_or(RequestFailure::NoData(arguments.name))?;
                io_force::set_signal(&signal, &arguments.value, &mut run.debugger.controller)?;
                let value = cell_view::signal_at(&run.debugger.controller, &signal);
                return Ok(SetVariableResponse { value, ..SetVariableResponse::default() });
            }
        };
        let format = session.format(arguments.format.as_ref());
        let value = run.evaluator.assign_child(
            &mut run.debugger.controller,
            &inside,
            &arguments.name,
            &arguments.value,
            format,
        );
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

    use crate::test_client::{COUNTER, INPUT, TestClient};

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
    fn a_signal_is_forced_and_all_views_agree() {
        let mut client = TestClient::stopped(INPUT);
        let boards = client.scope("I/O");
        let board = client.body("variables", json!({ "variablesReference": boards }))["variables"][0].clone();
        let signals = board["variablesReference"].clone();
        let answer = client.body("setVariable", assignment(&signals, "start", "true"));
        assert_eq!(answer["value"], "true (input)");
        let shown = client.body("variables", json!({ "variablesReference": signals }));
        assert_eq!(shown["variables"][0]["value"], "true (input)");
        assert!(client.value("diIn").as_str().unwrap().starts_with("true"));
        assert_eq!(client.body("val3/io", json!({}))["signals"][0]["value"], 1.0);
        let wrong = client.failure("setVariable", assignment(&signals, "start", "yes"));
        assert_eq!(wrong, "`yes` is no value of a signal: write true, false or a number");
    }

    #[test]
    fn a_stale_handle_is_rejected() {
        let mut client = TestClient::stopped(COUNTER);
        let reason = client.failure("setVariable", assignment(&json!(99), "nCount", "1"));
        assert_eq!(reason, "this belongs to a stop that is over");
    }
}
