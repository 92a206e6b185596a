//! Comparison of fields.

use val3_lang::types::Attribute;

use crate::model::{FieldChange, Pair};
use crate::read::value::{Part, Value, field_name, shown_part};

/// Returns the fields that differ. A side without an explicit value (`is_written`) is shown as unknown.
pub(super) fn compare(old: &Value, new: &Value, is_written: Pair<bool>) -> Vec<FieldChange> {
    let text = |attribute: &Attribute, part: &Part, is_written: bool| is_written.then(|| shown_part(attribute, part));
    let both = old.parts().zip(new.parts());
    let differing = both.filter(|((_, old), (_, new))| old != new);
    let change =
        |((attribute, old), (_, new)): ((&'static Attribute, &Part), (&'static Attribute, &Part))| FieldChange {
            field: field_name(attribute).to_owned(),
            old: text(attribute, old, is_written.old),
            new: text(attribute, new, is_written.new),
        };
    differing.map(change).collect()
}
