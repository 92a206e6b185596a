//! TypeScript declarations from the definitions of a JSON schema.
//!
//! Covers the schemas that `schemars` derives from wire types. Any other keyword is an error, so that no declaration is
//! wider than its schema by accident. Ranges and lengths have no counterpart in TypeScript.

use std::fmt::Write as _;

use anyhow::{Context as _, Result, bail, ensure};
use serde_json::{Map, Value};

/// Keywords that do not change the type in TypeScript.
const WITHOUT_TYPE: &[&str] =
    &["$schema", "default", "description", "format", "maxItems", "maximum", "minItems", "minimum", "title"];
/// Prefix of references to definitions.
const DEFINITION: &str = "#/$defs/";

/// Returns an exported declaration for each definition, with its description as a comment: interfaces for objects,
/// type aliases for everything else.
///
/// # Errors
/// A definition contains an unsupported keyword.
pub fn declarations(definitions: &Map<String, Value>) -> Result<String> {
    let mut text = String::new();
    for (name, schema) in definitions {
        if !text.is_empty() {
            text.push('\n');
        }
        declaration(&mut text, name, schema).with_context(|| format!("declaring {name}"))?;
    }
    Ok(text)
}

fn declaration(text: &mut String, name: &str, schema: &Value) -> Result<()> {
    let keys = schema.as_object().context("a definition is an object")?;
    comment(text, "", keys);
    match (intersection(keys)?, alternatives(keys)) {
        (parts, _) if is_interface(keys) => writeln!(text, "export interface {name} {}", parts.text)?,
        (_, Some(alternatives)) if alternatives.len() > 1 => {
            write!(text, "export type {name} =")?;
            for alternative in alternatives {
                write!(text, "\n  | {}", type_of(alternative)?.text)?;
            }
            text.push_str(";\n");
        }
        (parts, _) => writeln!(text, "export type {name} = {};", parts.text)?,
    }
    Ok(())
}

/// Type as text; a compound is a union or an intersection, which needs parentheses within other types.
struct TypeText {
    text: String,
    is_compound: bool,
}

impl TypeText {
    fn simple(text: impl Into<String>) -> Self {
        Self { text: text.into(), is_compound: false }
    }

    /// Joins different types by an operator.
    fn joined(types: Vec<Self>, operator: &str) -> Self {
        let mut parts: Vec<Self> = Vec::new();
        for part in types {
            if !parts.iter().any(|known| known.text == part.text) {
                parts.push(part);
            }
        }
        let is_single = parts.len() == 1;
        let text = |part: &Self| if is_single { part.text.clone() } else { part.operand() };
        let is_compound = !is_single || parts.iter().any(|part| part.is_compound);
        Self { text: parts.iter().map(text).collect::<Vec<_>>().join(operator), is_compound }
    }

    fn operand(&self) -> String {
        if self.is_compound { format!("({})", self.text) } else { self.text.clone() }
    }
}

/// Whether the schema consists of the properties of one object.
fn is_interface(keys: &Map<String, Value>) -> bool {
    keys.contains_key("properties") && !["$ref", "allOf", "anyOf", "oneOf"].iter().any(|key| keys.contains_key(*key))
}

/// Alternatives of a schema without properties of its own.
fn alternatives(keys: &Map<String, Value>) -> Option<&Vec<Value>> {
    let alternatives = keys.get("oneOf").or_else(|| keys.get("anyOf"))?.as_array()?;
    let has_other = ["$ref", "allOf", "properties"].iter().any(|key| keys.contains_key(*key));
    (!has_other).then_some(alternatives)
}

fn type_of(schema: &Value) -> Result<TypeText> {
    match schema {
        Value::Bool(true) => Ok(TypeText::simple("unknown")),
        Value::Object(keys) => intersection(keys),
        _ => bail!("a schema is an object or `true`: {schema}"),
    }
}

/// Combines what the keywords of a schema require.
fn intersection(keys: &Map<String, Value>) -> Result<TypeText> {
    let mut parts = Vec::new();
    for (key, value) in keys {
        match key.as_str() {
            "type" if keys.contains_key("const") || keys.contains_key("enum") => {}
            "type" => parts.push(by_type(value, keys)?),
            "$ref" => {
                let name = value.as_str().and_then(|text| text.strip_prefix(DEFINITION));
                parts.push(TypeText::simple(name.with_context(|| format!("{value} is not in `$defs`"))?));
            }
            "const" => parts.push(literal(value)?),
            "enum" => parts.push(TypeText::joined(list(value)?.iter().map(literal).collect::<Result<_>>()?, " | ")),
            "oneOf" | "anyOf" => {
                parts.push(TypeText::joined(list(value)?.iter().map(type_of).collect::<Result<_>>()?, " | "));
            }
            "allOf" => {
                parts.push(TypeText::joined(list(value)?.iter().map(type_of).collect::<Result<_>>()?, " & "));
            }
            "properties" | "required" | "additionalProperties" | "items" | "prefixItems" => {
                ensure!(keys.contains_key("type"), "`{key}` without `type`");
            }
            other => ensure!(WITHOUT_TYPE.contains(&other), "the keyword `{other}` has no declaration"),
        }
    }
    Ok(if parts.is_empty() { TypeText::simple("unknown") } else { TypeText::joined(parts, " & ") })
}

fn by_type(value: &Value, keys: &Map<String, Value>) -> Result<TypeText> {
    if let Value::Array(names) = value {
        return Ok(TypeText::joined(names.iter().map(|name| by_type(name, keys)).collect::<Result<_>>()?, " | "));
    }
    Ok(match value.as_str() {
        Some(name @ ("string" | "boolean" | "null")) => TypeText::simple(name),
        Some("number" | "integer") => TypeText::simple("number"),
        Some("array") => array(keys)?,
        Some("object") => object(keys)?,
        _ => bail!("unknown type {value}"),
    })
}

fn array(keys: &Map<String, Value>) -> Result<TypeText> {
    if let Some(places) = keys.get("prefixItems") {
        let places: Vec<String> = list(places)?.iter().map(|place| Ok(type_of(place)?.text)).collect::<Result<_>>()?;
        return Ok(TypeText::simple(format!("readonly [{}]", places.join(", "))));
    }
    let item = keys.get("items").map_or_else(|| Ok(TypeText::simple("unknown")), type_of)?;
    // `readonly T[]` within another array would read `readonly readonly T[][]`.
    let is_array = item.text.starts_with("readonly ");
    let item = if is_array && !item.is_compound { format!("({})", item.text) } else { item.operand() };
    Ok(TypeText::simple(format!("readonly {item}[]")))
}

fn object(keys: &Map<String, Value>) -> Result<TypeText> {
    let others = match keys.get("additionalProperties") {
        None | Some(Value::Bool(false)) => None,
        Some(schema) => Some(type_of(schema)?.text),
    };
    let Some(Value::Object(properties)) = keys.get("properties") else {
        return Ok(TypeText::simple(format!("Record<string, {}>", others.as_deref().unwrap_or("unknown"))));
    };
    let required = keys.get("required").map(list).transpose()?.map_or(&[][..], Vec::as_slice);
    let mut text = "{\n".to_owned();
    for (name, schema) in properties {
        if let Value::Object(keys) = schema {
            comment(&mut text, "  ", keys);
        }
        let mark = if required.iter().any(|known| known == name) { "" } else { "?" };
        writeln!(text, "  {}{mark}: {};", property(name), indented(&type_of(schema)?.text))?;
    }
    if let Some(others) = others {
        writeln!(text, "  [key: string]: {others};")?;
    }
    text.push('}');
    // A short object, such as the tag of a variant, is written in one line.
    let is_short = properties.len() == 1 && !text.contains("/**") && text.matches('\n').count() == 2;
    Ok(TypeText::simple(if is_short {
        text.replace(['\n'], "").replace("{  ", "{ ").replace(";}", " }")
    } else {
        text
    }))
}

/// Name of a property, quoted if it is no identifier.
fn property(name: &str) -> String {
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '$';
    let is_identifier = name.chars().all(is_letter) && !name.starts_with(|c: char| c.is_ascii_digit());
    if is_identifier { name.to_owned() } else { format!("{name:?}") }
}

fn literal(value: &Value) -> Result<TypeText> {
    ensure!(!value.is_object() && !value.is_array(), "{value} is no literal");
    Ok(TypeText::simple(value.to_string()))
}

fn list(value: &Value) -> Result<&Vec<Value>> {
    value.as_array().with_context(|| format!("{value} is no list"))
}

fn indented(text: &str) -> String {
    text.replace('\n', "\n  ")
}

/// Writes the description as a documentation comment.
fn comment(text: &mut String, indent: &str, keys: &Map<String, Value>) {
    let Some(description) = keys.get("description").and_then(Value::as_str) else { return };
    let description = description.trim().replace("*/", "*\u{200b}/");
    if description.contains('\n') {
        text.push_str(&format!("{indent}/**\n"));
        for line in description.lines() {
            text.push_str(format!("{indent} * {line}").trim_end());
            text.push('\n');
        }
        text.push_str(&format!("{indent} */\n"));
    } else {
        text.push_str(&format!("{indent}/** {description} */\n"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn declared(definitions: Value) -> String {
        declarations(definitions.as_object().unwrap()).unwrap()
    }

    #[test]
    fn an_object_becomes_an_interface() {
        let found = declared(json!({ "Point": {
            "type": "object",
            "description": "A point.",
            "properties": {
                "name": { "type": "string" },
                "key": { "type": ["string", "null"], "description": "Index\nor key." },
                "near-by": { "type": "array", "items": { "anyOf": [{ "$ref": "#/$defs/Point" }, { "type": "null" }] } },
                "pose": { "type": "array", "items": { "type": "array", "items": { "type": "number" } } },
            },
            "required": ["name", "pose"],
        } }));
        let expected = "/** A point. */\nexport interface Point {\n  /**\n   * Index\n   * or key.\n   */\n  \
            key?: string | null;\n  name: string;\n  \"near-by\"?: readonly (Point | null)[];\n  \
            pose: readonly (readonly number[])[];\n}\n";
        assert_eq!(found, expected);
    }

    #[test]
    fn variants_become_a_union() {
        let found = declared(json!({ "Message": { "oneOf": [
            { "type": "object", "properties": { "kind": { "type": "string", "const": "end" } }, "required": ["kind"],
              "$ref": "#/$defs/End" },
            { "enum": ["a", 1] },
            { "type": "array", "prefixItems": [{ "type": "integer" }, true] },
        ] } }));
        let expected = "export type Message =\n  | End & { kind: \"end\" }\n  | \"a\" | 1\n  \
            | readonly [number, unknown];\n";
        assert_eq!(found, expected);
    }

    #[test]
    fn maps_and_aliases_have_their_types() {
        let found = declared(json!({
            "Any": { "type": "object", "additionalProperties": true },
            "Counts": { "type": "object", "additionalProperties": { "type": "integer", "minimum": 0 } },
        }));
        let expected = "export type Any = Record<string, unknown>;\n\nexport type Counts = Record<string, number>;\n";
        assert_eq!(found, expected);
    }

    #[test]
    fn an_unsupported_keyword_is_an_error() {
        let wrong = json!({ "Text": { "type": "string", "pattern": "x" } });
        let error = declarations(wrong.as_object().unwrap()).unwrap_err();
        assert_eq!(format!("{error:#}"), "declaring Text: the keyword `pattern` has no declaration");
    }
}
