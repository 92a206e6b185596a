//! `val3/table`: present elements of an array or collection.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use val3_debug::TableRow;
use val3_machine::event::seconds;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::DebugRequest;
use crate::series::{self, Series};
use crate::session::{DebugSession, NamedData};

/// Number of elements in a response if the client does not set it.
const COUNT: usize = 100;

/// The request `val3/table`.
pub(crate) enum Table {}

impl DebugRequest for Table {
    const COMMAND: &'static str = "val3/table";
    type Arguments = TableArguments;
    type Body = TableBody;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: TableArguments,
    ) -> Result<TableBody, RequestFailure> {
        let TableArguments { name, variables_reference, frame_id, data_id, start, count } = arguments;
        let named = name.as_deref().map(|name| NamedData { name, variables_reference, frame: frame_id });
        let data = session.chosen_data(data_id.as_deref(), named.as_ref(), run)?;
        let start = start.unwrap_or_default() as usize;
        let range = start..start.saturating_add(count.map_or(COUNT, |count| count as usize));
        let controller = &mut run.debugger.controller;
        let no_table = || RequestFailure::Rejected(format!("`{}` is no array or collection", data.id()));
        let table = data.table(controller, range).ok_or_else(no_table)?;
        let now = seconds(controller.now());
        let (type_name, series) = series::described(table.form);
        let rows = table.rows.into_iter().map(ArrayElement::from).collect();
        let name = session.breakpoints.know_data(data);
        Ok(TableBody { name, type_name, series, now, count: table.count, rows })
    }
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct TableArguments {
    /// Name of the array or collection, as for `dataBreakpointInfo`. Required without `dataId`.
    name: Option<String>,
    /// Handle of the value or scope that contains it.
    variables_reference: Option<i32>,
    /// Stack frame in which the name is evaluated.
    frame_id: Option<i32>,
    /// Full name from an earlier response, also at a later stop.
    data_id: Option<String>,
    /// Number of the first element; 0 by default.
    start: Option<u32>,
    /// Largest number of elements; 100 by default.
    count: Option<u32>,
}

#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct TableBody {
    /// Full name of the array or collection, as in `dataId`.
    name: String,
    /// Type, including array sizes.
    #[serde(rename = "type")]
    type_name: String,
    /// Numbers in each element; empty for strings and user types.
    series: Vec<Series>,
    /// Present time since the start of the run, in seconds.
    now: f64,
    /// Number of all elements.
    count: usize,
    /// Requested elements.
    rows: Vec<ArrayElement>,
}

/// Element of an array or collection.
#[derive(Debug, Serialize, JsonSchema)]
struct ArrayElement {
    /// Index or key, for example `[1,0]` or `["left"]`.
    index: String,
    /// Value.
    value: String,
    /// Numbers of the value, in the order of `series`. `null` stands for a number that is not finite or cannot be read.
    numbers: Vec<Option<f64>>,
}

impl From<TableRow> for ArrayElement {
    fn from(TableRow { index, value, numbers }: TableRow) -> Self {
        Self { index, value, numbers }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{MAIN_THREAD, TestClient};

    const ARRAYS: &str = "num nGrid[2,2]\njoint jMany[2]\nstring sNames[2]\nnum nCount\n\nprogram start()\nbegin\n  \
                          nGrid[1,0]=2.5\n  jMany[1].j2=90\n  sNames[0]=\"a\"\n  delay(1)\nend\n";

    /// Runs to the last line.
    fn finished() -> TestClient {
        let mut client = TestClient::stopped(ARRAYS);
        for _ in 0..3 {
            client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        }
        client
    }

    /// Formats the rows: `[1,0]=2.5 [2.5]`.
    fn rows(table: &Value) -> Vec<String> {
        let row = |row: &Value| {
            format!("{}={} {}", row["index"].as_str().unwrap(), row["value"].as_str().unwrap(), row["numbers"])
        };
        table["rows"].as_array().unwrap().iter().map(row).collect()
    }

    #[test]
    fn elements_have_indexes_values_and_numbers() {
        let mut client = finished();
        let grid = client.body("val3/table", json!({ "name": "nGrid" }));
        assert_eq!(
            (&grid["name"], &grid["type"], &grid["count"]),
            (&json!("main:nGrid"), &json!("num[2,2]"), &json!(4))
        );
        assert_eq!(rows(&grid), ["[0,0]=0 [0.0]", "[0,1]=0 [0.0]", "[1,0]=2.5 [2.5]", "[1,1]=0 [0.0]"]);
        assert_eq!(grid["series"], json!([{ "name": "", "unit": null, "isDigital": false }]));
        let joints = client.body("val3/table", json!({ "name": "jMany", "start": 1 }));
        assert_eq!((rows(&joints).len(), &joints["count"]), (1, &json!(2)));
        assert_eq!(joints["rows"][0]["numbers"], json!([0.0, 90.0, 0.0, 0.0, 0.0, 0.0]));
        assert_eq!(joints["series"][1], json!({ "name": "j2", "unit": "degrees", "isDigital": false }));
        let names = client.body("val3/table", json!({ "name": "sNames", "count": 1 }));
        assert_eq!((rows(&names), &names["series"]), (vec!["[0]=\"a\" []".to_owned()], &json!([])));
        let beyond = client.body("val3/table", json!({ "name": "sNames", "start": 9 }));
        assert_eq!((&beyond["rows"], &beyond["count"]), (&json!([]), &json!(2)));
    }

    #[test]
    fn a_table_is_requested_again_at_a_later_stop() {
        let mut client = TestClient::stopped(ARRAYS);
        let globals = client.scope("Globals");
        let first = client.body("val3/table", json!({ "name": "nGrid", "variablesReference": globals }));
        client.stop_after("next", json!({ "threadId": MAIN_THREAD }));
        let again = client.body("val3/table", json!({ "dataId": first["name"], "start": 2, "count": 1 }));
        assert_eq!(rows(&again), ["[1,0]=2.5 [2.5]"]);
    }

    #[test]
    fn other_data_are_rejected() {
        let mut client = finished();
        assert_eq!(
            client.failure("val3/table", json!({ "name": "jMany[1]" })),
            "`main:jMany[1]` is no array or collection"
        );
        assert_eq!(client.failure("val3/table", json!({ "name": "nOther" })), "there is no `nOther` here");
        assert_eq!(client.failure("val3/table", json!({})), "`name` or `dataId` is required");
    }
}
