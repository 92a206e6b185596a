//! Validation of messages against the schema of the specification, for tests.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::error::Error;
use std::fmt;

use jsonschema::Validator;
use serde_json::{Value, json};

/// The schema of the specification.
pub const SCHEMA: &str = include_str!("../schema/debugAdapterProtocol.json");

/// Validates messages. A definition is compiled when it is first used.
#[derive(Debug)]
pub struct SchemaValidator {
    schema: Value,
    compiled: BTreeMap<String, Validator>,
}

impl SchemaValidator {
    /// A validator without compiled definitions.
    ///
    /// # Errors
    /// If the schema is not JSON.
    pub fn new() -> serde_json::Result<Self> {
        // `restart` has the arguments of either `launch` or `attach`. Every object matches both, so `oneOf` would
        // reject every object.
        let schema = serde_json::from_str(&SCHEMA.replace("\"oneOf\"", "\"anyOf\""))?;
        Ok(Self { schema, compiled: BTreeMap::new() })
    }

    /// Validates a message of either direction against the definition for its type and name.
    ///
    /// A custom message has a `/` in its name (`val3/pose`). Only its envelope is validated.
    ///
    /// # Errors
    /// The message has no definition, or does not match its definition.
    pub fn validate(&mut self, message: &Value) -> Result<(), InvalidMessage> {
        let definition = definition_of(message)?;
        let validator = self.compile(&definition)?;
        let mismatches = validator.iter_errors(message);
        let lines = mismatches.map(|error| format!("{definition}{}: {error}", error.instance_path()));
        let lines = lines.collect::<Vec<_>>();
        if lines.is_empty() { Ok(()) } else { Err(InvalidMessage::Mismatches(lines)) }
    }

    fn compile(&mut self, definition: &str) -> Result<&Validator, InvalidMessage> {
        let entry = match self.compiled.entry(definition.to_owned()) {
            Entry::Occupied(entry) => return Ok(entry.into_mut()),
            Entry::Vacant(entry) => entry,
        };
        let definitions = self.schema.get("definitions");
        if definitions.and_then(|all| all.get(definition)).is_none() {
            return Err(InvalidMessage::NoDefinition(definition.to_owned()));
        }
        let reference = format!("#/definitions/{definition}");
        // Draft 4 ignores the siblings of a `$ref`.
        let schema = json!({
            "$schema": self.schema.get("$schema"),
            "definitions": definitions,
            "allOf": [{ "$ref": reference }],
        });
        let validator =
            jsonschema::validator_for(&schema).map_err(|error| InvalidMessage::Schema(error.to_string()))?;
        Ok(entry.insert(validator))
    }
}

/// Reason why a message is invalid.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum InvalidMessage {
    /// The type is missing, or is no type of messages. Contains the type.
    UnknownType(Option<String>),
    /// A request or event has no name. Contains the message as JSON.
    NoName(String),
    /// The specification has no definition with this name.
    NoDefinition(String),
    /// The definition cannot be compiled. Contains the reason.
    Schema(String),
    /// The message does not match its definition. Contains a line for each mismatch: definition, path in the message and
    /// reason.
    Mismatches(Vec<String>),
}

impl fmt::Display for InvalidMessage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownType(kind) => write!(f, "a message of the type {kind:?}"),
            Self::NoName(message) => write!(f, "a message without a name: {message}"),
            Self::NoDefinition(definition) => write!(f, "the specification has no {definition}"),
            Self::Schema(reason) => f.write_str(reason),
            Self::Mismatches(lines) => f.write_str(&lines.join("\n")),
        }
    }
}

impl Error for InvalidMessage {}

/// The name of the definition for a message.
fn definition_of(message: &Value) -> Result<String, InvalidMessage> {
    let text = |key| message.get(key).and_then(Value::as_str);
    let (kind, name) = match text("type") {
        Some("request") => ("Request", text("command")),
        Some("response") if message.get("success") == Some(&Value::Bool(false)) => {
            return Ok("ErrorResponse".to_owned());
        }
        Some("response") => ("Response", text("command")),
        Some("event") => ("Event", text("event")),
        other => return Err(InvalidMessage::UnknownType(other.map(str::to_owned))),
    };
    let name = name.ok_or_else(|| InvalidMessage::NoName(message.to_string()))?;
    if name.contains('/') {
        return Ok(kind.to_owned());
    }
    let mut letters = name.chars();
    let first = letters.next().map(|first| first.to_ascii_uppercase());
    Ok(format!("{}{}{kind}", first.unwrap_or_default(), letters.as_str()))
}
