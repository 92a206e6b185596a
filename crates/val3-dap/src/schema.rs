//! JSON schema of the requests `val3/…`.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

/// Definition with the arguments and bodies of all requests, by command.
const REQUESTS: &str = "DebugRequests";

/// Schema of a request.
pub(crate) struct RequestSchema {
    command: &'static str,
    arguments: Value,
    body: Value,
    /// Types to which the arguments and the body refer.
    definitions: Map<String, Value>,
}

impl RequestSchema {
    /// The schema of a command with these types.
    pub(crate) fn of<A: JsonSchema, B: JsonSchema>(command: &'static str) -> Self {
        let mut received = SchemaSettings::draft2020_12().for_deserialize().into_generator();
        let mut sent = SchemaSettings::draft2020_12().for_serialize().into_generator();
        let (arguments, body) = (received.subschema_for::<A>().to_value(), sent.subschema_for::<B>().to_value());
        let mut definitions = received.take_definitions(true);
        definitions.extend(sent.take_definitions(true));
        Self { command, arguments, body, definitions }
    }
}

/// Combines the schemas of requests. Its root is the object of all requests.
pub(crate) fn of_requests(requests: impl Iterator<Item = RequestSchema>) -> Value {
    let (mut definitions, mut commands) = (Map::new(), Map::new());
    for RequestSchema { command, arguments, body, definitions: types } in requests {
        definitions.extend(types);
        let parts = json!({ "arguments": arguments, "body": body });
        commands.insert(command.to_owned(), object(parts, format!("Request `{command}`.")));
    }
    let all = object(Value::Object(commands), "Arguments and bodies of the requests `val3/…`, by command.".to_owned());
    definitions.insert(REQUESTS.to_owned(), all);
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$ref": format!("#/$defs/{REQUESTS}"),
        "$defs": definitions,
    })
}

/// Object with these properties, all of them required.
fn object(properties: Value, description: String) -> Value {
    let required: Vec<&String> = properties.as_object().into_iter().flat_map(Map::keys).collect();
    let required = json!(required);
    json!({ "type": "object", "description": description, "properties": properties, "required": required })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::requests::debug_requests_schema;

    #[test]
    fn each_reference_has_a_definition() {
        let schema = debug_requests_schema();
        let definitions = schema["$defs"].as_object().unwrap();
        let text = schema.to_string();
        let names = text.split("#/$defs/").skip(1).map(|rest| rest.split('"').next().unwrap());
        for name in names {
            assert!(definitions.contains_key(name), "{name}");
        }
        let commands = definitions[REQUESTS]["properties"].as_object().unwrap();
        assert!(commands.contains_key("val3/pose") && commands.keys().all(|name| name.starts_with("val3/")));
    }
}
