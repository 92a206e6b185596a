//! JSON schema of the requests `val3/…` that the debug adapter and the language server add to their protocols.
//!
//! The types of a request derive their schemas. [`RequestSchema`] describes one request, and
//! [`RequestWords::schema`] combines all requests of a protocol.

use std::error::Error;
use std::fmt;

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

/// Words of a protocol for its requests.
#[derive(Debug, Clone, Copy)]
pub struct RequestWords {
    /// Name of the definition that lists all requests.
    pub requests: &'static str,
    /// Property with the received part of a request, for example `arguments`.
    pub received: &'static str,
    /// Property with the sent part of a request, for example `body`.
    pub sent: &'static str,
    /// Description of the definition that lists all requests.
    pub description: &'static str,
}

/// Schema of a request.
#[derive(Debug)]
pub struct RequestSchema {
    name: &'static str,
    received: Value,
    sent: Value,
    /// Types to which the received and the sent part refer, by name.
    definitions: [Map<String, Value>; 2],
}

/// Two different types with the same name in a schema.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NameConflict {
    /// Name of both types.
    pub name: String,
}

impl fmt::Display for NameConflict {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "the schema has two types with the name `{}`: rename one of them", self.name)
    }
}

impl Error for NameConflict {}

impl RequestSchema {
    /// Returns the schema of the request with this name, whose received and sent parts have the types `R` and `S`.
    #[must_use]
    pub fn of<R: JsonSchema, S: JsonSchema>(name: &'static str) -> Self {
        let mut received = SchemaSettings::draft2020_12().for_deserialize().into_generator();
        let mut sent = SchemaSettings::draft2020_12().for_serialize().into_generator();
        Self {
            name,
            received: received.subschema_for::<R>().to_value(),
            sent: sent.subschema_for::<S>().to_value(),
            definitions: [received.take_definitions(true), sent.take_definitions(true)],
        }
    }
}

impl RequestWords {
    /// Combines the schemas of requests. The root is the object of all requests.
    ///
    /// # Errors
    /// Two types have the same name and different schemas.
    pub fn schema(&self, requests: impl IntoIterator<Item = RequestSchema>) -> Result<Value, NameConflict> {
        let (mut definitions, mut names) = (Map::new(), Map::new());
        for request in requests {
            for (name, schema) in request.definitions.into_iter().flatten() {
                add(&mut definitions, name, schema)?;
            }
            let parts = json!({ self.received: request.received, self.sent: request.sent });
            names.insert(request.name.to_owned(), object(parts, &format!("Request `{}`.", request.name)));
        }
        add(&mut definitions, self.requests.to_owned(), object(Value::Object(names), self.description))?;
        Ok(json!({
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "$ref": format!("#/$defs/{}", self.requests),
            "$defs": definitions,
        }))
    }
}

fn add(definitions: &mut Map<String, Value>, name: String, schema: Value) -> Result<(), NameConflict> {
    if definitions.get(&name).is_some_and(|earlier| *earlier != schema) {
        return Err(NameConflict { name });
    }
    definitions.insert(name, schema);
    Ok(())
}

/// Object with these properties, all of them required.
fn object(properties: Value, description: &str) -> Value {
    let required: Vec<&String> = properties.as_object().into_iter().flat_map(Map::keys).collect();
    let required = json!(required);
    json!({ "type": "object", "description": description, "properties": properties, "required": required })
}

#[cfg(test)]
mod tests {
    use super::*;

    const WORDS: RequestWords =
        RequestWords { requests: "Requests", received: "params", sent: "result", description: "All requests." };

    /// A point.
    #[derive(JsonSchema)]
    #[expect(dead_code, reason = "only its schema is used")]
    struct Point {
        x: f64,
    }

    #[derive(JsonSchema)]
    #[schemars(rename = "Point")]
    #[expect(dead_code, reason = "only its schema is used")]
    struct OtherPoint {
        y: f64,
    }

    #[test]
    fn types_of_several_requests_are_defined_once() {
        let requests = [RequestSchema::of::<Point, f64>("first"), RequestSchema::of::<(), Vec<Point>>("second")];
        let schema = WORDS.schema(requests).unwrap();
        let definitions = schema["$defs"].as_object().unwrap();
        assert_eq!(definitions.keys().collect::<Vec<_>>(), ["Point", "Requests"]);
        assert_eq!(schema["$ref"], "#/$defs/Requests");
        let first = &definitions["Requests"]["properties"]["first"];
        assert_eq!(first["properties"]["params"], json!({ "$ref": "#/$defs/Point" }));
        assert_eq!(first["required"], json!(["params", "result"]));
    }

    #[test]
    fn two_types_with_the_same_name_are_rejected() {
        let requests = [RequestSchema::of::<Point, f64>("first"), RequestSchema::of::<(), OtherPoint>("second")];
        let conflict = WORDS.schema(requests).unwrap_err();
        assert_eq!(conflict.to_string(), "the schema has two types with the name `Point`: rename one of them");
    }
}
