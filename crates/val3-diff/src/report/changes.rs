//! Formatting of old and new values.

use crate::model::{FieldChange, ValuePair};

/// Formats `5 → 7`.
pub(super) fn arrow(pair: &ValuePair<String>) -> String {
    format!("{} → {}", pair.old, pair.new)
}

/// Formats `5 → 7`, where a side may be missing.
pub(super) fn optional_arrow(old: Option<&String>, new: Option<&String>) -> String {
    let shown = |side: Option<&String>| {
        side.map_or("(not written)".to_owned(), |text| if text.is_empty() { "\"\"".to_owned() } else { text.clone() })
    };
    format!("{} → {}", shown(old), shown(new))
}

/// Formats `x 100 → 112.5, father fA → fB`.
pub(super) fn fields(fields: &[FieldChange]) -> String {
    let field = |change: &FieldChange| {
        let values = optional_arrow(change.old.as_ref(), change.new.as_ref());
        if change.field.is_empty() { values } else { format!("{} {values}", change.field) }
    };
    fields.iter().map(field).collect::<Vec<_>>().join(", ")
}
