//! `val3/history`: recorded writes of a value.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use val3_debug::{DataWrite, TaskFrame};
use val3_machine::event::seconds;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::DebugRequest;
use crate::series::{self, Series};
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
        let HistoryArguments { name, variables_reference, frame_id, data_id, .. } = &arguments;
        let named =
            name.as_deref().map(|name| NamedData { name, variables_reference: *variables_reference, frame: *frame_id });
        let data = session.chosen_data(data_id.as_deref(), named.as_ref(), run)?;
        let count = arguments.count.map_or(COUNT, |count| count as usize);
        let found = session.search_writes(&data, count, run)?;
        let (type_name, series) = found.form.map_or_else(Default::default, series::described);
        let initial = found.initial;
        Ok(HistoryBody {
            name: session.breakpoints.know_data(data),
            type_name,
            series,
            now: seconds(run.debugger.controller.now()),
            writes: found.writes.into_iter().map(Write::from).collect(),
            more: initial.is_none(),
            since: initial.as_ref().map(|initial| seconds(initial.time)),
            initial_numbers: initial.as_ref().map(|initial| initial.numbers.clone()),
            initial: initial.map(|initial| initial.value),
        })
    }
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct HistoryArguments {
    /// Name of the variable, element, field or signal, as for `dataBreakpointInfo`. Required without `dataId`.
    name: Option<String>,
    /// Handle of the value or scope that contains it.
    variables_reference: Option<i32>,
    /// Stack frame in which the name is evaluated.
    frame_id: Option<i32>,
    /// Full name from an earlier response, also at a later stop.
    data_id: Option<String>,
    /// Largest number of writes; 100 by default.
    count: Option<u32>,
}

#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct HistoryBody {
    /// Full name of the value, as in `dataId`.
    name: String,
    /// Type, including array sizes; empty if the value was never in memory.
    #[serde(rename = "type")]
    type_name: String,
    /// Numbers in each value; empty for strings, arrays, collections and user types.
    series: Vec<Series>,
    /// Present time since the start of the run, in seconds.
    now: f64,
    /// Writes that have changed the value, the newest first.
    writes: Vec<Write>,
    /// Whether there are earlier writes.
    more: bool,
    /// Value before the first write; `null` if there are earlier writes.
    initial: Option<String>,
    /// Numbers of `initial`, in the order of `series`.
    initial_numbers: Option<Vec<Option<f64>>>,
    /// Time since which the value is `initial`, in seconds: the beginning of the history, or of a local variable's
    /// program.
    since: Option<f64>,
}

/// Write that has changed a value.
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
struct Write {
    /// Time since the start of the run, in seconds.
    t: f64,
    /// Value after the write.
    value: String,
    /// Numbers of the value, in the order of `series`; empty if the value is not in memory. `null` stands for a number
    /// that is not finite or cannot be read.
    numbers: Vec<Option<f64>>,
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
    fn from(DataWrite { time, task, line, value, numbers }: DataWrite) -> Self {
        Self { t: seconds(time), value, numbers, task, source: line.map(WriteLine::from) }
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
        assert_eq!((&input["initial"], &input["type"]), (&json!("false"), &json!("dio")));
        assert_eq!((&write["numbers"], &input["initialNumbers"]), (&json!([1.0]), &json!([0.0])));
        assert_eq!(input["series"], json!([{ "name": "", "unit": null, "isDigital": true }]));
    }

    /// Formats a series: `j1:degrees`.
    fn series_text(series: &Value) -> String {
        let digital = if series["isDigital"] == true { " digital" } else { "" };
        format!("{}:{}{digital}", series["name"].as_str().unwrap(), series["unit"].as_str().unwrap_or(""))
    }

    #[test]
    fn values_have_numbers_with_units() {
        let listing = "num nCount = 2\njoint jHome\npoint pPick\nbool bDone\nstring sName\nnum nList[2]\n\n\
                       program start()\nbegin\n  jHome.j2=90\n  pPick.trsf.x=1.5\n  bDone=true\n  sName=\"a\"\n  \
                       nList[1]=3\n  nCount=1/3\nend\n";
        let mut client = TestClient::launched(listing, json!({ "stopOnExit": true }));
        client.run();
        let mut shown = String::new();
        for name in ["nCount", "jHome", "jHome.j2", "pPick", "pPick.trsf.x", "bDone", "sName", "nList", "nList[1]"] {
            let body = client.body("val3/history", json!({ "name": name }));
            let series: Vec<String> = body["series"].as_array().unwrap().iter().map(series_text).collect();
            let (numbers, initial) = (&body["writes"][0]["numbers"], &body["initialNumbers"]);
            let kind = body["type"].as_str().unwrap();
            shown += &format!("{name} {kind} [{}] {initial} -> {numbers}\n", series.join(" "));
            assert_eq!(body["since"], 0.0);
        }
        let axes = "j1:degrees j2:degrees j3:degrees j4:degrees j5:degrees j6:degrees";
        let pose = "x:mm y:mm z:mm rx:degrees ry:degrees rz:degrees";
        let expected = format!(
            "nCount num [:] [2.0] -> [0.3333333333333333]\n\
             jHome joint [{axes}] [0.0,0.0,0.0,0.0,0.0,0.0] -> [0.0,90.0,0.0,0.0,0.0,0.0]\n\
             jHome.j2 num [:degrees] [0.0] -> [90.0]\n\
             pPick point [{pose}] [0.0,0.0,0.0,0.0,0.0,0.0] -> [1.5,0.0,0.0,0.0,0.0,0.0]\n\
             pPick.trsf.x num [:mm] [0.0] -> [1.5]\n\
             bDone bool [: digital] [0.0] -> [1.0]\n\
             sName string [] [] -> []\n\
             nList num[2] [] [] -> []\n\
             nList[1] num [:] [0.0] -> [3.0]\n"
        );
        assert_eq!(shown, expected);
    }

    #[test]
    fn the_history_is_requested_again_at_a_later_stop() {
        let listing = "program start()\nbegin\n  call work()\n  delay(1)\nend\n\nprogram work()\n  num l_nAt\nbegin\n  \
                       delay(0.5)\n  l_nAt=1\n  l_nAt=2\nend\n";
        let mut client = TestClient::stopped(listing);
        client.stop_after("stepIn", json!({ "threadId": MAIN_THREAD }));
        let (_, frame) = client.thread_and_frame();
        let first = client.body("val3/history", json!({ "name": "l_nAt", "frameId": frame }));
        assert_eq!((&first["writes"], &first["initial"], &first["type"]), (&json!([]), &json!("0"), &json!("num")));
        client.stop_after("stepOut", json!({ "threadId": MAIN_THREAD }));
        let again = client.body("val3/history", json!({ "dataId": first["name"] }));
        let values: Vec<_> = again["writes"].as_array().unwrap().iter().map(|write| &write["value"]).collect();
        assert_eq!(values, ["not in memory", "2", "1"]);
        assert_eq!((&again["writes"][0]["numbers"], &again["type"]), (&json!([]), &json!("num")));
        assert!(again["since"].as_f64().unwrap() < 0.1 && again["now"].as_f64().unwrap() >= 0.5);
        assert_eq!(client.failure("val3/history", json!({ "dataId": "nAt" })), "`nAt` is not known in this run");
        assert_eq!(client.failure("val3/history", json!({})), "`name` or `dataId` is required");
    }

    #[test]
    fn unknown_names_are_rejected() {
        let mut client = TestClient::stopped(COUNTER);
        assert_eq!(client.failure("val3/history", json!({ "name": "nOther" })), "there is no `nOther` here");
        client.action("continue", json!({ "threadId": MAIN_THREAD }));
        assert_eq!(client.failure("val3/history", json!({ "name": "nCount" })), "notStopped");
    }
}
