//! Arguments of calls.

use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::refusal::Refusal;

/// Reads the arguments of a call.
///
/// # Errors
///
/// An argument is missing, unknown or has the wrong type. The error contains the expected form of the arguments.
pub(crate) fn read<A: DeserializeOwned>(
    tool: &str,
    arguments: Map<String, Value>,
    schema: &Map<String, Value>,
) -> Result<A, Refusal> {
    serde_json::from_value(Value::Object(arguments))
        .map_err(|error| Refusal(format!("the arguments of `{tool}` are wrong: {error}. Write {}", form(schema))))
}

/// Expected form of the arguments, such as `{"path": string (required), "max": integer}`.
fn form(schema: &Map<String, Value>) -> String {
    let required = schema.get("required").and_then(Value::as_array);
    let is_required = |name: &str| required.is_some_and(|names| names.iter().any(|required| required == name));
    let properties = schema.get("properties").and_then(Value::as_object).into_iter().flatten();
    let shown = properties.map(|(name, property)| {
        let kind = property.get("type").and_then(Value::as_str).unwrap_or("value");
        format!("\"{name}\": {kind}{}", if is_required(name) { " (required)" } else { "" })
    });
    format!("{{{}}}", shown.collect::<Vec<_>>().join(", "))
}

/// Default path of a call: the first root.
pub(crate) fn here() -> String {
    ".".to_owned()
}
