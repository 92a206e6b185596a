//! Keys of a TOML file's tables, for editors.

use schemars::JsonSchema;
use serde_json::Value;

use crate::schema::{choices, keys, property, schema_of, takes};

/// A key of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SchemaKey {
    /// Name.
    pub name: String,
    /// Description in Markdown.
    pub description: String,
    /// Form of the value.
    pub form: ValueForm,
}

/// Form of a key's value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ValueForm {
    /// A text in quotes.
    Text,
    /// A number, or `true` or `false`.
    Plain,
    /// A list in square brackets.
    List,
    /// An inline table.
    Table,
    /// A list of tables, each with a header `[[…]]`.
    Tables,
}

/// Returns the keys of the table at a path, in alphabetical order. Entries of a list are addressed by the key of the
/// list, without an index.
pub fn schema_keys<T: JsonSchema>(path: &[&str]) -> Vec<SchemaKey> {
    let schema = schema_of::<T>();
    let Some(table) = at(&schema, path) else { return Vec::new() };
    let described = keys(table).filter_map(|name| {
        let key = property(table, name)?;
        let description = key.get("description").and_then(Value::as_str).unwrap_or_default().to_owned();
        Some(SchemaKey { name: name.to_owned(), description, form: form(key) })
    });
    described.collect()
}

/// Returns the words that the key at a path accepts: the choices of a string, or `true` and `false`.
pub fn schema_words<T: JsonSchema>(path: &[&str]) -> Vec<String> {
    let schema = schema_of::<T>();
    match at(&schema, path) {
        Some(key) if takes(key, "boolean") => vec!["true".to_owned(), "false".to_owned()],
        Some(key) => choices(key).into_iter().map(str::to_owned).collect(),
        None => Vec::new(),
    }
}

/// Returns the schema at a path. For a list, this is the schema of its items.
fn at<'s>(schema: &'s Value, path: &[&str]) -> Option<&'s Value> {
    path.iter().try_fold(schema, |table, key| property(table, key).map(|key| key.get("items").unwrap_or(key)))
}

fn form(key: &Value) -> ValueForm {
    let has_tables = key.get("items").is_some_and(|items| items.get("properties").is_some());
    match key {
        _ if has_tables => ValueForm::Tables,
        _ if takes(key, "array") => ValueForm::List,
        _ if takes(key, "object") => ValueForm::Table,
        _ if takes(key, "number") || takes(key, "boolean") => ValueForm::Plain,
        _ => ValueForm::Text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Config;

    #[test]
    fn keys_have_forms_and_descriptions() {
        let keys = schema_keys::<Config>(&["run"]);
        let form = |name: &str| keys.iter().find(|key| key.name == name).unwrap().form;
        assert_eq!(
            [form("power"), form("start"), form("cell"), form("lines")],
            [ValueForm::Plain, ValueForm::List, ValueForm::Text, ValueForm::Table]
        );
        assert!(keys.iter().all(|key| !key.description.is_empty()));
        assert_eq!(schema_keys::<Config>(&["run", "no"]), []);
    }

    #[test]
    fn words_are_choices() {
        assert_eq!(schema_words::<Config>(&["run", "power"]), ["true", "false"]);
        assert!(schema_words::<Config>(&["rules", "V0101"]).contains(&"warning".to_owned()));
        assert_eq!(schema_words::<Config>(&["run", "cell"]), [""; 0]);
    }
}
