//! JSON schemas of TOML files, for editors and for the messages about wrong settings.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::Value;

use crate::Config;

/// Returns the schema of `val3.toml` as text, with a final newline. Editors read it from
/// `editors/schema/val3.schema.json`.
pub fn json_schema() -> String {
    json_schema_of::<Config>("val3.toml")
}

/// Returns the schema of a TOML file as text, with the title and a final newline.
pub fn json_schema_of<T: JsonSchema>(title: &str) -> String {
    let mut schema = schema_of::<T>();
    if let Some(object) = schema.as_object_mut() {
        object.insert("title".to_owned(), title.into());
    }
    format!("{schema:#}\n")
}

/// Returns the schema of an entire file, with all parts inlined.
pub(crate) fn schema_of<T: JsonSchema>() -> Value {
    // TOML editors support draft 7.
    let settings = SchemaSettings::draft07().with(|settings| settings.inline_subschemas = true);
    settings.into_generator().into_root_schema_for::<T>().to_value()
}

/// Returns the schema of the value under `key`.
pub(crate) fn property<'s>(schema: &'s Value, key: &str) -> Option<&'s Value> {
    let named = schema.get("properties").and_then(|properties| properties.get(key));
    named.or_else(|| schema.get("additionalProperties").filter(|any| any.is_object()))
}

/// Returns the declared keys.
pub(crate) fn keys(schema: &Value) -> impl Iterator<Item = &str> {
    schema.get("properties").and_then(Value::as_object).into_iter().flatten().map(|(key, _)| key.as_str())
}

/// Whether the schema accepts this type (`string`, `integer`, `number`, `boolean`, `array`, `object`).
pub(crate) fn takes(schema: &Value, ty: &str) -> bool {
    let includes = |one: &Value| one == ty || (one == "number" && ty == "integer");
    match schema.get("type") {
        Some(Value::Array(several)) => several.iter().any(includes),
        Some(only) => includes(only),
        _ => ty == "string",
    }
}

/// Returns the words that the schema accepts; empty if it accepts any string.
pub(crate) fn choices(schema: &Value) -> Vec<&str> {
    let listed = schema.get("enum").and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_str);
    let described = schema.get("oneOf").and_then(Value::as_array).into_iter().flatten();
    let described = described.filter_map(|one| one.get("const").or_else(|| one.get("enum")?.get(0))?.as_str());
    listed.chain(described).collect()
}

#[cfg(test)]
mod tests {
    use expect_test::expect_file;

    use super::*;

    /// `UPDATE_EXPECT=1 cargo test -p val3-config` updates the file.
    #[test]
    fn the_shipped_schema_is_up_to_date() {
        expect_file!["../../../editors/schema/val3.schema.json"].assert_eq(&json_schema());
    }

    #[test]
    fn every_setting_is_described() {
        let schema = schema_of::<Config>();
        let table = |key| property(&schema, key).unwrap();
        let tables =
            [&schema, table("lint"), table("format"), table("run"), property(table("run"), "profiles").unwrap()];
        for (table, key) in tables.into_iter().flat_map(|table| keys(table).map(move |key| (table, key))) {
            assert!(property(table, key).unwrap().get("description").is_some(), "{key}");
        }
    }

    #[test]
    fn levels_are_words() {
        let schema = schema_of::<Config>();
        let level = property(property(&schema, "rules").unwrap(), "V0101").unwrap();
        assert_eq!(choices(level), ["off", "on", "info", "warning", "error", "default"]);
    }
}
