//! Formatting of old and new values.

use crate::model::{FieldChange, ValuePair};

/// Formats `5 → 7`.
pub(super) fn arrow(pair: &ValuePair<String>) -> String {
    format!("{} → {}", pair.old, pair.new)
}

/// Formats `5 → 7`, where a side may be missing.
pub(super) fn optional_arrow(old: Option<&String>, new: Option<&String>) -> String {
    format!("{} → {}", optional_text(old), optional_text(new))
}

fn optional_text(text: Option<&String>) -> &str {
    match text.map(String::as_str) {
        None => "(not written)",
        Some("") => "\"\"",
        Some(text) => text,
    }
}

/// Formats `x 100 → 112.5, father fA → fB`.
pub(super) fn fields(fields: &[FieldChange]) -> String {
    fields.iter().map(field).collect::<Vec<_>>().join(", ")
}

fn field(change: &FieldChange) -> String {
    let values = optional_arrow(change.old.as_ref(), change.new.as_ref());
    if change.field.is_empty() { values } else { format!("{} {values}", change.field) }
}
