//! `val3/ioForce`: sets, locks, simulates or protects an input or output.

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Map, Value, json};
use val3_machine::controller::Controller;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::{DebugRequest, Empty};
use crate::requests::operate;
use crate::session::DebugSession;

/// The request `val3/ioForce`.
pub(crate) enum IoForce {}

impl DebugRequest for IoForce {
    const COMMAND: &'static str = "val3/ioForce";
    type Arguments = IoForceArguments;
    type Body = Empty;

    fn answer(
        _: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: IoForceArguments,
    ) -> Result<Empty, RequestFailure> {
        operate::act(keys(arguments)?, &mut run.debugger.controller)
    }
}

/// Sets a signal to a value as users write it: `true`, `on`, `0` or a number.
///
/// # Errors
/// The text is no value, or the signal cannot be set.
pub(crate) fn set_signal(path: &str, text: &str, controller: &mut Controller) -> Result<(), RequestFailure> {
    let level = match text.trim() {
        "true" | "on" => json!(true),
        "false" | "off" => json!(false),
        text => {
            let number = text.parse().ok().filter(|number: &f64| number.is_finite());
            json!(number.ok_or_else(|| RequestFailure::Rejected(format!(
                "`{text}` is no value of a signal: write true, false or a number"
            )))?)
        }
    };
    let keys = Map::from_iter([("io".to_owned(), json!({ path: level }))]);
    operate::act(keys, controller).map(drop)
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct IoForceArguments {
    /// Link, for example `BasicIO-1\%I0`.
    link: String,
    /// Value from the hardware; the value to hold if `lock` is true.
    value: Option<SignalLevel>,
    /// Whether the operator holds the value.
    lock: Option<bool>,
    /// Whether the controller simulates the signal.
    simulate: Option<bool>,
    /// Whether the output is reserved for the system.
    protect: Option<bool>,
}

/// Value of a digital or analog signal.
#[derive(Debug, Clone, Copy, Deserialize, serde::Serialize, JsonSchema)]
#[serde(untagged)]
enum SignalLevel {
    /// Digital.
    Digital(bool),
    /// Analog.
    Analog(f64),
}

/// Converts the arguments to keys of a script.
fn keys(arguments: IoForceArguments) -> Result<Map<String, Value>, RequestFailure> {
    let IoForceArguments { link, value, lock, simulate, protect } = arguments;
    let mut keys = Map::new();
    let mut insert = |key: &str, value: Value| keys.insert(key.to_owned(), value);
    if let Some(level) = value {
        insert("io", json!({ link.as_str(): level }));
    }
    match (lock, value) {
        (Some(true), Some(level)) => _ = insert("lock", json!({ link.as_str(): level })),
        (Some(true), None) => _ = insert("lock", json!(link)),
        (Some(false), _) => _ = insert("unlock", json!(link)),
        (None, _) => {}
    }
    for (key, state) in [("simulate", simulate), ("protect", protect)] {
        if let Some(state) = state {
            insert(key, json!({ link.as_str(): state }));
        }
    }
    if keys.is_empty() { Err(RequestFailure::NoArgument("value, lock, simulate or protect")) } else { Ok(keys) }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn wrong_arguments_are_named() {
        let mut client = TestClient::stopped(EMPTY);
        let mut failure = |arguments| client.failure("val3/ioForce", arguments);
        assert!(failure(json!({ "link": "x", "lock": 1 })).contains("`lock`"));
        assert!(failure(json!({ "link": "x", "hold": true })).contains("`hold`"));
        assert!(failure(json!({ "value": true })).contains("`link`"));
        assert_eq!(failure(json!({ "link": "x" })), "set value, lock, simulate or protect");
    }
}
