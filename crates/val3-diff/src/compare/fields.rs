//! Comparison of fields.

use crate::model::{FieldChange, ValuePair};
use crate::read::value::{FileValue, field_name, shown_part};

/// Returns the fields that differ. A side without an explicit value (`is_written`) is shown as unknown.
pub(super) fn compare(old: &FileValue, new: &FileValue, is_written: ValuePair<bool>) -> Vec<FieldChange> {
    let mut changes = Vec::new();
    for ((attribute, old), (_, new)) in old.parts().zip(new.parts()) {
        if old != new {
            changes.push(FieldChange {
                field: field_name(attribute).to_owned(),
                old: is_written.old.then(|| shown_part(attribute, old)),
                new: is_written.new.then(|| shown_part(attribute, new)),
            });
        }
    }
    changes
}
