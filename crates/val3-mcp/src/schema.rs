//! JSON schemas of arguments, in the subset that all clients support.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value};

/// Returns the schema of arguments: an object without references, titles, `null` and dialect names.
pub(crate) fn schema<A: JsonSchema>() -> Map<String, Value> {
    let settings = SchemaSettings::draft2020_12().with(|settings| {
        settings.inline_subschemas = true;
        settings.meta_schema = None;
    });
    let mut value = settings.into_generator().into_root_schema_for::<A>().to_value();
    simplify(&mut value);
    match value {
        Value::Object(mut object) => {
            object.remove("description");
            object.entry("properties").or_insert_with(|| Value::Object(Map::new()));
            object
        }
        _ => Map::new(),
    }
}

/// Removes parts that clients reject, or that cost more tokens than their information is worth.
fn simplify(value: &mut Value) {
    match value {
        Value::Object(object) => {
            // A property may have any name, for example a keyword's name. Therefore, only keywords of schemas are
            // removed.
            let is_schema = object.get("type").is_some_and(|kind| kind.is_string() || kind.is_array());
            if is_schema {
                for keyword in ["title", "format", "minimum", "maximum"] {
                    object.remove(keyword);
                }
                object.retain(|key, value| match key.as_str() {
                    "default" => !value.is_null(),
                    // Some clients reject a schema that is `true`.
                    "additionalProperties" => *value != true,
                    _ => true,
                });
                if let Some(kind) = object.get_mut("type") {
                    without_null(kind);
                }
            }
            object.values_mut().for_each(simplify);
        }
        Value::Array(items) => items.iter_mut().for_each(simplify),
        _ => {}
    }
}

/// Replaces `["string", "null"]` by `"string"`, because an optional argument can be omitted.
fn without_null(kind: &mut Value) {
    let Value::Array(kinds) = kind else { return };
    kinds.retain(|kind| kind != "null");
    if let [only] = kinds.as_slice() {
        *kind = only.clone();
    }
}
