//! Validation of messages against the schema of the specification, for tests.

use std::collections::BTreeMap;

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
        // The arguments of `restart` are the arguments of `launch` or `attach`. Every object is both, so that `oneOf` would
        // allow none.
        let schema = serde_json::from_str(&SCHEMA.replace("\"oneOf\"", "\"anyOf\""))?;
        Ok(Self { schema, compiled: BTreeMap::new() })
    }

    /// Validates a message of either direction against the definition for its type and name.
    ///
    /// A custom message has a `/` in its name (`val3/pose`). Only its envelope is validated.
    ///
    /// # Errors
    /// The definition, and all its mismatches with their paths in the message, one on each line.
    pub fn validate(&mut self, message: &Value) -> Result<(), String> {
        let definition = definition_of(message)?;
        let validator = self.compile(&definition)?;
        let mismatches = validator.iter_errors(message);
        let lines = mismatches.map(|error| format!("{definition}{}: {error}", error.instance_path()));
        let lines = lines.collect::<Vec<_>>();
        if lines.is_empty() { Ok(()) } else { Err(lines.join("\n")) }
    }

    fn compile(&mut self, definition: &str) -> Result<&Validator, String> {
        if !self.compiled.contains_key(definition) {
            let definitions = self.schema.get("definitions");
            if definitions.and_then(|all| all.get(definition)).is_none() {
                return Err(format!("the specification has no {definition}"));
            }
            let reference = format!("#/definitions/{definition}");
            // Draft 4 ignores the neighbours of a `$ref`.
            let schema = json!({
                "$schema": self.schema.get("$schema"),
                "definitions": definitions,
                "allOf": [{ "$ref": reference }],
            });
            let validator = jsonschema::validator_for(&schema).map_err(|error| error.to_string())?;
            self.compiled.insert(definition.to_owned(), validator);
        }
        self.compiled.get(definition).ok_or_else(|| format!("{definition} was not compiled"))
    }
}

/// The name of the definition for a message.
fn definition_of(message: &Value) -> Result<String, String> {
    let text = |key| message.get(key).and_then(Value::as_str);
    let (kind, name) = match text("type") {
        Some("request") => ("Request", text("command")),
        Some("response") if message.get("success") == Some(&Value::Bool(false)) => {
            return Ok("ErrorResponse".to_owned());
        }
        Some("response") => ("Response", text("command")),
        Some("event") => ("Event", text("event")),
        other => return Err(format!("a message of the type {other:?}")),
    };
    let name = name.ok_or_else(|| format!("a message without a name: {message}"))?;
    if name.contains('/') {
        return Ok(kind.to_owned());
    }
    let mut letters = name.chars();
    let first = letters.next().map(|first| first.to_ascii_uppercase());
    Ok(format!("{}{}{kind}", first.unwrap_or_default(), letters.as_str()))
}
