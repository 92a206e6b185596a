//! `val3/past`: extent of the history.

use schemars::JsonSchema;
use serde::Serialize;
use val3_machine::event::seconds;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::{DebugRequest, NoArguments};
use crate::session::DebugSession;

/// The request `val3/past`.
pub(crate) enum Past {}

impl DebugRequest for Past {
    const COMMAND: &'static str = "val3/past";
    type Arguments = NoArguments;
    type Body = PastBody;

    fn answer(_: &mut DebugSession, run: &mut DebuggedRun<'_>, _: NoArguments) -> Result<PastBody, RequestFailure> {
        let reach = run.debugger.reach().ok_or(RequestFailure::NotRecorded)?;
        Ok(PastBody {
            first: seconds(reach.first.time),
            time: seconds(reach.time),
            cycles: reach.cycles,
            is_whole: reach.is_whole,
            snapshots: reach.snapshots,
            bytes: reach.bytes,
        })
    }
}

#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct PastBody {
    /// Earliest moment, in seconds since the start.
    first: f64,
    /// Time from the earliest moment to the present, in seconds.
    time: f64,
    /// The same time in controller cycles.
    cycles: u64,
    /// Whether the earliest moment is the beginning of the run.
    is_whole: bool,
    /// Number of snapshots.
    snapshots: usize,
    /// Size of the history, in bytes.
    bytes: u64,
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn the_history_begins_with_the_run() {
        let mut client = TestClient::stopped(EMPTY);
        let past = client.body("val3/past", json!({}));
        assert_eq!((&past["first"], &past["isWhole"]), (&json!(0.0), &json!(true)));
    }
}
