//! Validation of a configuration against the schema: unknown keys and values of a wrong type.

use std::ops::Range;

use camino::Utf8Path;
use serde_json::Value;
use toml::Spanned;
use toml::de::{DeTable, DeValue};
use val3_lang::suggest::{nearest, question};

use crate::ConfigError;
use crate::schema::{choices, keys, property, takes};

/// An invalid setting.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct SettingError {
    pub(crate) range: Range<usize>,
    pub(crate) message: String,
    pub(crate) help: String,
}

impl SettingError {
    /// Adds the file and its text.
    pub(crate) fn in_file(self, path: &Utf8Path, text: &str) -> ConfigError {
        let Self { range, message, help } = self;
        ConfigError { path: path.to_owned(), text: text.to_owned(), range, message, help }
    }
}

/// Returns the first error of `table` in file order.
pub(crate) fn first_error(table: &DeTable<'_>, schema: &Value) -> Option<SettingError> {
    let mut errors = Vec::new();
    validate_table(table, schema, "", &mut errors);
    errors.into_iter().min_by_key(|error| error.range.start)
}

fn validate_table(table: &DeTable<'_>, schema: &Value, path: &str, errors: &mut Vec<SettingError>) {
    for (key, value) in table {
        let name = key.get_ref();
        let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
        match property(schema, name) {
            Some(schema) => validate_value(value, schema, &path, errors),
            None => errors.push(unknown_key(name, key.span(), &path, schema)),
        }
    }
}

fn validate_value(value: &Spanned<DeValue<'_>>, schema: &Value, path: &str, errors: &mut Vec<SettingError>) {
    let ty = type_of(value.get_ref());
    if !takes(schema, ty) {
        let message = format!("{} must be {}, and this is {}", quoted(path), expected(schema), article(ty));
        return errors.push(SettingError { range: value.span(), message, help: String::new() });
    }
    match value.get_ref() {
        DeValue::Table(table) => validate_table(table, schema, path, errors),
        DeValue::Array(values) => {
            let Some(items) = schema.get("items") else { return };
            values.iter().for_each(|value| validate_value(value, items, &format!("{path}[]"), errors));
        }
        DeValue::String(word) => errors.extend(unknown_word(word, value.span(), schema, path)),
        DeValue::Integer(number) if number.as_str().starts_with('-') && is_whole(schema) => {
            let message = format!("{} cannot be negative", quoted(path));
            errors.push(SettingError { range: value.span(), message, help: String::new() });
        }
        _ => {}
    }
}

/// Whether the setting is an integer: a count or a percentage, which is never negative.
fn is_whole(schema: &Value) -> bool {
    schema.get("type").is_some_and(|ty| ty == "integer")
}

/// Formats the name of a setting for a message; `exclude[]` means the entries of a list.
fn quoted(path: &str) -> String {
    match path.strip_suffix("[]") {
        Some(list) => format!("each entry of `{list}`"),
        None => format!("`{path}`"),
    }
}

fn unknown_key(name: &str, range: Range<usize>, path: &str, schema: &Value) -> SettingError {
    let help = question(nearest(name, keys(schema)))
        .unwrap_or_else(|| format!("known settings: {}", keys(schema).collect::<Vec<_>>().join(", ")));
    SettingError { range, message: format!("there is no setting `{path}`"), help }
}

fn unknown_word(word: &str, range: Range<usize>, schema: &Value, path: &str) -> Option<SettingError> {
    let choices = choices(schema);
    if choices.is_empty() || choices.contains(&word) {
        return None;
    }
    let help = question(nearest(word, choices.iter().copied())).unwrap_or_default();
    Some(SettingError {
        range,
        message: format!("{} must be {}, not \"{word}\"", quoted(path), expected(schema)),
        help,
    })
}

/// Formats the values that a setting accepts.
fn expected(schema: &Value) -> String {
    let choices = choices(schema);
    if !choices.is_empty() {
        return format!("one of {}", choices.join(", "));
    }
    let types = ["string", "integer", "number", "boolean", "array", "object"];
    let taken = types.into_iter().filter(|ty| takes(schema, ty)).map(article);
    taken.collect::<Vec<_>>().join(" or ")
}

fn type_of(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "string",
        DeValue::Integer(_) => "integer",
        DeValue::Float(_) => "number",
        DeValue::Boolean(_) => "boolean",
        DeValue::Datetime(_) => "date",
        DeValue::Array(_) => "array",
        DeValue::Table(_) => "object",
    }
}

fn article(ty: &str) -> &'static str {
    match ty {
        "string" => "a text in quotes",
        "integer" => "a whole number",
        "boolean" => "`true` or `false`",
        "array" => "a list in square brackets",
        "object" => "a table",
        "number" => "a number with a fraction",
        _ => "a date",
    }
}
