//! `val3/history`: recorded writes of a value.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use val3_debug::{DataWrite, TaskFrame};
use val3_machine::event::seconds;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::DebugRequest;
use crate::session::{DebugSession, NamedData};

/// Number of writes in a response if the client does not set it.
const COUNT: usize = 100;

/// The request `val3/history`.
pub(crate) enum History {}

impl DebugRequest for History {
    const COMMAND: &'static str = "val3/history";
    type Arguments = HistoryArguments;
    type Body = HistoryBody;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: HistoryArguments,
    ) -> Result<HistoryBody, RequestFailure> {
        let HistoryArguments { name, variables_reference, frame_id, count } = &arguments;
        let named = NamedData { name, variables_reference: *variables_reference, frame: *frame_id };
        let data = session.named_data(&named, run)?.map_err(RequestFailure::Rejected)?;
        let count = count.map_or(COUNT, |count| count as usize);
        let found = session.search_writes(&data, count, run)?;
        Ok(HistoryBody {
            name: data.id().to_owned(),
            writes: found.writes.into_iter().map(Write::from).collect(),
            more: found.initial.is_none(),
            initial: found.initial,
        })
    }
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct HistoryArguments {
    /// Name of the variable, element, field or signal, as for `dataBreakpointInfo`.
    name: String,
    /// Handle of the value or scope that contains it.
    variables_reference: Option<i32>,
    /// Stack frame in which the name is evaluated.
    frame_id: Option<i32>,
    /// Largest number of writes; 100 by default.
    count: Option<u32>,
}

#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct HistoryBody {
    /// Full name of the value, as in `dataId`.
    name: String,
    /// Writes that have changed the value, the newest first.
    writes: Vec<Write>,
    /// Whether there are earlier writes.
    more: bool,
    /// Value before the first write; `null` if there are earlier writes.
    initial: Option<String>,
}

/// Write that has changed a value.
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
struct Write {
    /// Time since the start of the run, in seconds.
    t: f64,
    /// Value after the write.
    value: String,
    /// Task name; `null` for a change from outside, for example by an input or the debugger.
    task: Option<String>,
    /// Line that wrote.
    source: Option<WriteLine>,
}

/// Line that wrote a value.
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
struct WriteLine {
    /// Application or library name.
    application: String,
    /// Program name.
    program: String,
    /// Line of the file, from 1.
    line: u32,
    /// Path of the file.
    file: String,
}

impl From<DataWrite> for Write {
    fn from(DataWrite { time, task, line, value }: DataWrite) -> Self {
        Self { t: seconds(time), value, task, source: line.map(WriteLine::from) }
    }
}

impl From<TaskFrame> for WriteLine {
    fn from(TaskFrame { application, program, file, row, .. }: TaskFrame) -> Self {
        Self { application, program, line: row, file }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{COUNTER, INPUT, MAIN_THREAD, TestClient, source};

    /// Returns the handle of the board `Io`.
    fn board(client: &mut TestClient) -> Value {
        let signals = client.scope("I/O");
        client.body("variables", json!({ "variablesReference": signals }))["variables"][0]["variablesReference"].clone()
    }

    fn write(line: u64, value: &str, body: &Value) {
        assert_eq!((&body["value"], &body["task"]), (&json!(value), &json!("main~")));
        let expected = json!({
            "application": "main", "program": "start", "line": line, "file": source("start")["path"],
        });
        assert_eq!(body["source"], expected);
    }

    #[test]
    fn writes_are_listed_with_their_lines() {
        let listing = "num nCount\n\nprogram start()\nbegin\n  nCount=1\n  delay(0.5)\n  nCount=2\n  nCount=2\n  \
                       nCount=3\nend\n";
        let mut client = TestClient::launched(listing, json!({ "stopOnExit": true }));
        client.run();
        let (_, frame) = client.thread_and_frame();
        let all = client.body("val3/history", json!({ "name": "nCount", "frameId": frame }));
        assert_eq!((&all["name"], &all["more"], &all["initial"]), (&json!("main:nCount"), &json!(false), &json!("0")));
        let writes = all["writes"].as_array().unwrap();
        for (body, (line, value)) in writes.iter().zip([(9, "3"), (7, "2"), (5, "1")]) {
            write(line, value, body);
        }
        assert_eq!(writes.len(), 3);
        assert!(writes[0]["t"].as_f64().unwrap() >= 0.5 && writes[2]["t"].as_f64().unwrap() < 0.1);
        let newest = client.body("val3/history", json!({ "name": "nCount", "count": 1 }));
        assert_eq!((&newest["writes"], &newest["more"]), (&json!([writes[0]]), &json!(true)));
        assert_eq!(newest["initial"], json!(null));
        assert_eq!((client.value("nCount"), client.place().1), (json!("3"), 10), "the run has not moved");
    }

    #[test]
    fn a_value_in_a_scope_and_an_input_have_a_history() {
        let mut client = TestClient::stopped(INPUT);
        // The run stops because no task can continue.
        client.stop_after("continue", json!({ "threadId": MAIN_THREAD }));
        let (globals, signals) = (client.scope("Globals"), board(&mut client));
        client.body("setVariable", json!({ "variablesReference": signals, "name": "start", "value": "true" }));
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        let stale = client.failure("val3/history", json!({ "name": "nCount", "variablesReference": globals }));
        assert_eq!(stale, "this belongs to a stop that is over");
        let (globals, signals) = (client.scope("Globals"), board(&mut client));
        let count = client.body("val3/history", json!({ "name": "nCount", "variablesReference": globals }));
        write(6, "1", &count["writes"][0]);
        let input = client.body("val3/history", json!({ "name": "start", "variablesReference": signals }));
        let write = &input["writes"][0];
        assert_eq!((&write["value"], &write["task"], &write["source"]), (&json!("true"), &json!(null), &json!(null)));
        assert_eq!(input["initial"], "false");
    }

    #[test]
    fn unknown_names_are_rejected() {
        let mut client = TestClient::stopped(COUNTER);
        assert_eq!(client.failure("val3/history", json!({ "name": "nOther" })), "there is no `nOther` here");
        client.action("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(client.failure("val3/history", json!({ "name": "nCount" })), "notStopped");
    }
}
