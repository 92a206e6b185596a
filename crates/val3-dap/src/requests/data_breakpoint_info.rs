//! `dataBreakpointInfo`: whether a value can have a data breakpoint.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::DataBreakpointAccessType;
use crate::protocol::{DataBreakpointInfoArguments, DataBreakpointInfoResponse};
use crate::request::DebugRequest;
use crate::session::{DebugSession, NamedData};

/// The request `dataBreakpointInfo`.
pub(crate) enum DataBreakpointInfo {}

impl DebugRequest for DataBreakpointInfo {
    const COMMAND: &'static str = "dataBreakpointInfo";
    type Arguments = DataBreakpointInfoArguments;
    type Body = DataBreakpointInfoResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: DataBreakpointInfoArguments,
    ) -> Result<DataBreakpointInfoResponse, RequestFailure> {
        let named = NamedData {
            name: &arguments.name,
            variables_reference: arguments.variables_reference,
            frame: arguments.frame_id,
        };
        let watched = session.named_data(&named, run)?;
        Ok(match watched {
            Ok(data) => watchable(session.breakpoints.know_data(data)),
            Err(description) => DataBreakpointInfoResponse { description, ..DataBreakpointInfoResponse::default() },
        })
    }
}

fn watchable(id: String) -> DataBreakpointInfoResponse {
    let access_types =
        [DataBreakpointAccessType::Read, DataBreakpointAccessType::Write, DataBreakpointAccessType::ReadWrite];
    DataBreakpointInfoResponse {
        description: id.clone(),
        data_id: Some(id),
        access_types: Some(access_types.to_vec()),
        ..DataBreakpointInfoResponse::default()
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{COUNTER, TestClient};

    #[test]
    fn a_variable_index_is_that_of_this_moment() {
        let listing = "num nAt = 2\nnum nList[4]\n\nprogram start()\nbegin\n  nList[nAt]=1\n  delay(1)\nend\n";
        let mut client = TestClient::stopped(listing);
        let (_, frame) = client.thread_and_frame();
        let body = client.body("dataBreakpointInfo", json!({ "name": "nList[nAt]", "frameId": frame }));
        assert_eq!(body["dataId"], "main:nList[2]");
        let none = client.body("dataBreakpointInfo", json!({ "name": "nList[nAt]+1", "frameId": frame }));
        assert_eq!(none["dataId"], json!(null));
    }

    #[test]
    fn a_variable_of_a_stack_frame_can_have_a_breakpoint() {
        let mut client = TestClient::stopped(COUNTER);
        let (_, frame) = client.thread_and_frame();
        let expected = json!({
            "dataId": "main:nCount",
            "description": "main:nCount",
            "accessTypes": ["read", "write", "readWrite"],
        });
        assert_eq!(client.body("dataBreakpointInfo", json!({ "name": "nCount", "frameId": frame })), expected);
        let globals = client.scope("Globals");
        let child = json!({ "name": "nCount", "variablesReference": globals });
        assert_eq!(client.body("dataBreakpointInfo", child), expected);
    }

    #[test]
    fn a_local_variable_is_identified_by_task_and_stack_frame() {
        let mut client = TestClient::stopped("program start()\n  num l_nSum\nbegin\n  delay(1)\nend\n");
        let (_, frame) = client.thread_and_frame();
        let body = client.body("dataBreakpointInfo", json!({ "name": "l_nSum", "frameId": frame }));
        assert_eq!(body["dataId"], "main~/0/l_nSum");
    }

    #[test]
    fn a_signal_can_have_a_breakpoint() {
        let mut client = TestClient::stopped(COUNTER);
        let body = client.body("dataBreakpointInfo", json!({ "name": "Io\\start" }));
        assert_eq!((&body["dataId"], &body["description"]), (&json!("io:Io\\start"), &json!("io:Io\\start")));
        let signals = client.scope("I/O");
        let board = client.body("variables", json!({ "variablesReference": signals }))["variables"][0].clone();
        let child = json!({ "name": "start", "variablesReference": board["variablesReference"] });
        assert_eq!(client.body("dataBreakpointInfo", child)["dataId"], "io:Io\\start");
    }

    #[test]
    fn an_unknown_name_has_no_data_id() {
        let mut client = TestClient::stopped(COUNTER);
        let expected = json!({ "dataId": null, "description": "there is no `nOther` here" });
        assert_eq!(client.body("dataBreakpointInfo", json!({ "name": "nOther" })), expected);
    }

    #[test]
    fn a_property_of_the_cell_has_no_data_id() {
        let mut client = TestClient::stopped(COUNTER);
        let robot = client.scope("Robot");
        let expected = json!({ "dataId": null, "description": "`speed` is computed from other values" });
        let property = json!({ "name": "speed", "variablesReference": robot });
        assert_eq!(client.body("dataBreakpointInfo", property), expected);
    }

    #[test]
    fn stale_handles_are_rejected() {
        let mut client = TestClient::stopped(COUNTER);
        for handle in ["frameId", "variablesReference"] {
            let reason = client.failure("dataBreakpointInfo", json!({ "name": "nCount", handle: 99 }));
            assert_eq!(reason, "this belongs to a stop that is over", "{handle}");
        }
    }
}
