//! Settings that the schema does not allow: unknown keys and values of a wrong type, each with its place.

use std::ops::Range;

use serde_json::Value;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::schema::{choices, keys, property, takes};

/// A setting that is not allowed.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Fault {
    pub(crate) range: Range<usize>,
    pub(crate) message: String,
    pub(crate) help: String,
}

/// The first fault of `table` in the order of the text.
pub(crate) fn first_fault(table: &DeTable<'_>, schema: &Value) -> Option<Fault> {
    let mut faults = Vec::new();
    of_table(table, schema, "", &mut faults);
    faults.into_iter().min_by_key(|fault| fault.range.start)
}

fn of_table(table: &DeTable<'_>, schema: &Value, path: &str, faults: &mut Vec<Fault>) {
    for (key, value) in table {
        let name = key.get_ref();
        let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
        match property(schema, name) {
            Some(schema) => of_value(value, schema, &path, faults),
            None => faults.push(unknown_key(name, key.span(), &path, schema)),
        }
    }
}

fn of_value(value: &Spanned<DeValue<'_>>, schema: &Value, path: &str, faults: &mut Vec<Fault>) {
    let ty = type_of(value.get_ref());
    if !takes(schema, ty) {
        let message = format!("{} must be {}, and this is {}", quoted(path), expected(schema), article(ty));
        return faults.push(Fault { range: value.span(), message, help: String::new() });
    }
    match value.get_ref() {
        DeValue::Table(table) => of_table(table, schema, path, faults),
        DeValue::Array(values) => {
            let Some(items) = schema.get("items") else { return };
            values.iter().for_each(|value| of_value(value, items, &format!("{path}[]"), faults));
        }
        DeValue::String(word) => faults.extend(unknown_word(word, value.span(), schema, path)),
        DeValue::Integer(number) if number.as_str().starts_with('-') => {
            let message = format!("{} cannot be negative", quoted(path));
            faults.push(Fault { range: value.span(), message, help: String::new() });
        }
        _ => {}
    }
}

/// The name of a setting in a message; `exclude[]` stands for the entries of a list.
fn quoted(path: &str) -> String {
    match path.strip_suffix("[]") {
        Some(list) => format!("each entry of `{list}`"),
        None => format!("`{path}`"),
    }
}

fn unknown_key(name: &str, range: Range<usize>, path: &str, schema: &Value) -> Fault {
    let help = match nearest(name, keys(schema)) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("known here: {}", keys(schema).collect::<Vec<_>>().join(", ")),
    };
    Fault { range, message: format!("there is no setting `{path}`"), help }
}

fn unknown_word(word: &str, range: Range<usize>, schema: &Value, path: &str) -> Option<Fault> {
    let choices = choices(schema);
    if choices.is_empty() || choices.contains(&word) {
        return None;
    }
    let help = match nearest(word, choices.iter().copied()) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => String::new(),
    };
    Some(Fault { range, message: format!("{} must be {}, not \"{word}\"", quoted(path), expected(schema)), help })
}

/// The words for what a setting takes.
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

/// The word that was probably meant.
pub(crate) fn nearest<'w>(word: &str, words: impl Iterator<Item = &'w str>) -> Option<&'w str> {
    let limit = (word.chars().count() / 3).clamp(1, 3);
    let near = words.map(|other| (strsim::osa_distance(&word.to_lowercase().replace('_', "-"), other), other));
    near.filter(|(distance, _)| *distance <= limit).min().map(|(_, other)| other)
}
