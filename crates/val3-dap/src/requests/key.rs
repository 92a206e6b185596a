//! `val3/key`: presses keys of the pendant.

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Map, Value};

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::{DebugRequest, Empty};
use crate::requests::operate;
use crate::session::DebugSession;

/// The request `val3/key`.
pub(crate) enum Key {}

impl DebugRequest for Key {
    const COMMAND: &'static str = "val3/key";
    type Arguments = KeyArguments;
    type Body = Empty;

    fn answer(
        _: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: KeyArguments,
    ) -> Result<Empty, RequestFailure> {
        let keys = keys(arguments)?;
        operate::act(keys, &mut run.debugger.controller)
    }
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct KeyArguments {
    /// Name or code of a key that is pressed immediately.
    key: Option<KeyName>,
    /// Keys that are typed when the program reads them, as in a script.
    keys: Option<String>,
}

/// Name or code of a key.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
enum KeyName {
    /// Code.
    Code(u16),
    /// Name, for example `F1`.
    Name(String),
}

impl From<KeyName> for Value {
    fn from(key: KeyName) -> Self {
        match key {
            KeyName::Code(code) => code.into(),
            KeyName::Name(name) => name.into(),
        }
    }
}

/// Converts the arguments to keys of a script.
fn keys(KeyArguments { key, keys }: KeyArguments) -> Result<Map<String, Value>, RequestFailure> {
    let key = key.map(|key| ("key".to_owned(), key.into()));
    let keys = keys.map(|keys| ("keys".to_owned(), keys.into()));
    let entries: Map<String, Value> = key.into_iter().chain(keys).collect();
    if entries.is_empty() { Err(RequestFailure::NoArgument("key or keys")) } else { Ok(entries) }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn a_key_is_a_name_or_a_code() {
        let mut client = TestClient::stopped(EMPTY);
        for key in [json!("F1"), json!(65)] {
            assert_eq!(client.body("val3/key", json!({ "key": key })), json!({}));
        }
        assert_eq!(client.failure("val3/key", json!({})), "set key or keys");
    }
}
