//! `val3/variableFilter`: filter of the global variables in scopes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use val3_debug::VariableFilter;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `val3/variableFilter`.
pub(crate) enum VariableFilterRequest {}

impl DebugRequest for VariableFilterRequest {
    const COMMAND: &'static str = "val3/variableFilter";
    type Arguments = VariableFilterArguments;
    type Body = VariableFilterBody;

    fn answer(
        session: &mut DebugSession,
        _: &mut DebuggedRun<'_>,
        arguments: VariableFilterArguments,
    ) -> Result<VariableFilterBody, RequestFailure> {
        if let Some(text) = arguments.filter {
            let filter = match text.trim() {
                "" => None,
                text => Some(text.parse().map_err(RequestFailure::rejected)?),
            };
            session.filter_variables(filter);
        }
        let filter = session.start.settings.variable_filter.as_ref();
        Ok(VariableFilterBody { filter: filter.map(VariableFilter::text).unwrap_or_default().to_owned() })
    }
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct VariableFilterArguments {
    /// New filter; empty to show all variables. The filter does not change without this argument.
    filter: Option<String>,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct VariableFilterBody {
    /// Present filter; empty without a filter.
    filter: String,
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{TestClient, source};

    const MANY: &str = "num nPush\nnum nPop\nstring sName\n\nprogram start()\nbegin\n  nPush=1\n  delay(1)\nend\n";

    /// Names of the variables in a scope.
    fn names(client: &mut TestClient, scope: &str) -> Vec<Value> {
        let scope = client.scope(scope);
        let variables = client.body("variables", json!({ "variablesReference": scope }));
        variables["variables"].as_array().unwrap().iter().map(|variable| variable["name"].clone()).collect()
    }

    #[test]
    fn a_filter_hides_other_variables_until_it_is_removed() {
        let mut client = TestClient::launched(MANY, json!({ "stopOnEntry": true, "variableFilter": "push" }));
        assert_eq!(names(&mut client, "Globals"), ["nPush"]);
        assert_eq!(client.body("val3/variableFilter", json!({}))["filter"], "push");
        let events = client.events("val3/variableFilter", json!({ "filter": "nP*, main:s?ame" }));
        assert_eq!(events[0].1["output"], "note: only global variables that match `nP*, main:s?ame` are shown\n");
        assert_eq!(names(&mut client, "Globals"), ["nPush", "nPop", "sName"]);
        client.body("val3/variableFilter", json!({ "filter": "other:n*" }));
        assert_eq!(names(&mut client, "Globals"), [""; 0]);
        client.body("val3/variableFilter", json!({ "filter": "" }));
        assert_eq!(names(&mut client, "Globals"), ["nPush", "nPop", "sName"]);
    }

    #[test]
    fn a_filtered_variable_is_set_watched_and_paged() {
        let mut client = TestClient::launched(MANY, json!({ "stopOnEntry": true, "variableFilter": "pop name" }));
        let globals = client.scope("Globals");
        let page = json!({ "variablesReference": globals, "start": 1, "count": 1 });
        assert_eq!(client.body("variables", page)["variables"][0]["name"], "sName");
        client.body("setVariable", json!({ "variablesReference": globals, "name": "nPop", "value": "3" }));
        assert_eq!(client.value("nPop"), "3");
        let info = client.body("dataBreakpointInfo", json!({ "variablesReference": globals, "name": "nPop" }));
        assert_eq!(info["dataId"], "main:nPop");
        client.body("setBreakpoints", json!({ "source": source("start"), "breakpoints": [] }));
        assert_eq!(client.value("nPush"), "0", "hidden variables can be read");
    }

    #[test]
    fn an_unusable_filter_is_rejected() {
        let mut client = TestClient::stopped(MANY);
        let reason = client.failure("val3/variableFilter", json!({ "filter": "n[" }));
        assert!(reason.contains("write a filter such as"), "{reason}");
        assert_eq!(client.body("val3/variableFilter", json!({}))["filter"], "");
    }
}
