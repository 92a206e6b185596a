//! `val3/io`: inputs and outputs.

use schemars::JsonSchema;
use serde::Serialize;
use val3_machine::controller::Controller;
use val3_machine::io::SignalKind;
use val3_view::direction;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::{DebugRequest, NoArguments};
use crate::session::DebugSession;

/// The request `val3/io`.
pub(crate) enum Io {}

impl DebugRequest for Io {
    const COMMAND: &'static str = "val3/io";
    type Arguments = NoArguments;
    type Body = IoBody;

    fn answer(_: &mut DebugSession, run: &mut DebuggedRun<'_>, _: NoArguments) -> Result<IoBody, RequestFailure> {
        Ok(IoBody { signals: signals(&run.debugger.controller) })
    }
}

#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct IoBody {
    /// All inputs and outputs.
    signals: Vec<Signal>,
}

/// An input or output.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
struct Signal {
    /// Link, for example `BasicIO-1\%I0`.
    link: String,
    /// `input` or `output`.
    direction: &'static str,
    /// Value; 0 or 1 if the signal is digital.
    value: f64,
    /// Whether the signal is digital.
    is_digital: bool,
    /// Whether the operator has locked the value.
    is_locked: bool,
    /// Whether the controller simulates the signal.
    is_simulated: bool,
    /// Whether the output is reserved for the system.
    is_protected: bool,
    /// Fault of the signal or its device.
    fault: Option<String>,
}

fn signals(controller: &Controller) -> Vec<Signal> {
    let io = &controller.devices.state.io;
    let signals = io.signals().filter_map(|id| {
        let (signal, forcing) = io.signal(id).zip(io.forcing(id))?;
        Some(Signal {
            link: signal.path.to_string(),
            direction: direction(signal.direction),
            value: io.next_image(id)?,
            is_digital: matches!(signal.kind, SignalKind::Digital),
            is_locked: forcing.is_locked,
            is_simulated: forcing.is_simulated,
            is_protected: signal.protected,
            fault: forcing.fault.map(|fault| format!("{fault:?}")),
        })
    });
    signals.collect()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn a_signal_is_returned_with_its_state() {
        let mut client = TestClient::stopped(EMPTY);
        let mut signal = json!({
            "link": "Io\\start",
            "direction": "input",
            "value": 0.0,
            "isDigital": true,
            "isLocked": false,
            "isSimulated": false,
            "isProtected": false,
            "fault": null,
        });
        assert_eq!(client.body("val3/io", json!({})), json!({ "signals": [signal] }));
        client.body("val3/ioForce", json!({ "link": "Io\\start", "value": true, "lock": true }));
        signal["value"] = json!(1.0);
        signal["isLocked"] = json!(true);
        assert_eq!(client.body("val3/io", json!({})), json!({ "signals": [signal] }));
    }

    #[test]
    fn a_cell_without_signals_has_an_empty_list() {
        let mut client = TestClient::stopped(EMPTY).without_signals();
        assert_eq!(client.body("val3/io", json!({})), json!({ "signals": [] }));
    }

    #[test]
    fn unknown_arguments_are_rejected() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(
            client.failure("val3/io", json!({ "link": "x" })),
            "the arguments of `val3/io` are wrong: unknown field `link`, there are no fields"
        );
    }
}
