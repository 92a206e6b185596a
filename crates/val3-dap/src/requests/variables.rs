//! `variables`: contents of a scope or a value.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{VariablesArguments, VariablesResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `variables`.
pub(crate) enum Variables {}

impl DebugRequest for Variables {
    const COMMAND: &'static str = "variables";
    type Arguments = VariablesArguments;
    type Body = VariablesResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: VariablesArguments,
    ) -> Result<VariablesResponse, RequestFailure> {
        let format = session.format(arguments.format.as_ref());
        let variables = session.handles.variables(&arguments, &mut run.debugger.controller, format);
        Ok(VariablesResponse { variables: variables.ok_or(RequestFailure::Stale)? })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{COUNTER, MAIN_THREAD, TestClient};

    const ARRAY: &str = "num nMany[3]\n\nprogram start()\nbegin\n  delay(1)\nend\n";

    fn element(index: u32) -> Value {
        json!({
            "name": format!("[{index}]"),
            "value": "0",
            "type": "num",
            "evaluateName": format!("nMany[{index}]"),
            "variablesReference": 0,
        })
    }

    #[test]
    fn a_scope_contains_its_variables() {
        let mut client = TestClient::stopped(COUNTER);
        let globals = client.scope("Globals");
        let expected = json!({ "variables": [{
            "name": "nCount",
            "value": "0",
            "type": "num",
            "evaluateName": "nCount",
            "variablesReference": 0,
        }] });
        assert_eq!(client.body("variables", json!({ "variablesReference": globals })), expected);
    }

    #[test]
    fn a_property_of_the_cell_is_read_only() {
        let mut client = TestClient::stopped(COUNTER);
        let robot = client.scope("Robot");
        let body = client.body("variables", json!({ "variablesReference": robot }));
        let mut properties = body["variables"].as_array().unwrap().iter();
        let expected = json!({
            "name": "power",
            "value": "off",
            "variablesReference": 0,
            "presentationHint": { "attributes": ["readOnly"] },
        });
        assert_eq!(properties.find(|property| property["name"] == "power"), Some(&expected));
    }

    #[test]
    fn an_array_contains_its_elements_page_by_page() {
        let mut client = TestClient::stopped(ARRAY);
        let globals = client.scope("Globals");
        let array = client.body("variables", json!({ "variablesReference": globals }))["variables"][0].clone();
        assert_eq!((&array["type"], &array["indexedVariables"]), (&json!("num[3]"), &json!(3)));
        let reference = &array["variablesReference"];
        for (start, count, page) in [(1, 1, vec![element(1)]), (1, 0, vec![element(1), element(2)]), (3, 1, Vec::new())]
        {
            let arguments = json!({ "variablesReference": reference, "start": start, "count": count });
            assert_eq!(client.body("variables", arguments)["variables"], json!(page), "{count} from {start}");
        }
    }

    #[test]
    fn a_filter_selects_indexed_or_named_variables() {
        let mut client = TestClient::stopped(COUNTER);
        let globals = client.scope("Globals");
        for (filter, count) in [("named", 1), ("indexed", 0)] {
            let arguments = json!({ "variablesReference": globals, "filter": filter });
            let variables = client.body("variables", arguments)["variables"].clone();
            assert_eq!(variables.as_array().unwrap().len(), count, "{filter}");
        }
    }

    #[test]
    fn numbers_are_hexadecimal_on_request() {
        let mut client = TestClient::stopped(COUNTER);
        let globals = client.scope("Globals");
        client.body("setVariable", json!({ "variablesReference": globals, "name": "nCount", "value": "255" }));
        let arguments = json!({ "variablesReference": globals, "format": { "hex": true } });
        assert_eq!(client.body("variables", arguments)["variables"][0]["value"], "0xFF");
    }

    #[test]
    fn handles_are_stale_after_the_run_has_continued() {
        let mut client = TestClient::stopped(COUNTER);
        let globals = client.scope("Globals");
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        for reference in [globals, json!(0), json!(-1)] {
            let reason = client.failure("variables", json!({ "variablesReference": reference }));
            assert_eq!(reason, "this belongs to a stop that is over");
        }
    }
}
