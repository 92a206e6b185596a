//! Comparison of fields.

use val3_lang::types::ValueAttribute;

use crate::model::{FieldChange, ValuePair};
use crate::read::value::{FileValue, ValuePart, field_name, shown_part};

/// Returns the fields that differ. A side without an explicit value (`is_written`) is shown as unknown.
pub(super) fn compare(old: &FileValue, new: &FileValue, is_written: ValuePair<bool>) -> Vec<FieldChange> {
    let text = |attribute: &ValueAttribute, part: &ValuePart, is_written: bool| {
        is_written.then(|| shown_part(attribute, part))
    };
    let both = old.parts().zip(new.parts());
    let differing = both.filter(|((_, old), (_, new))| old != new);
    let change = |((attribute, old), (_, new)): (
        (&'static ValueAttribute, &ValuePart),
        (&'static ValueAttribute, &ValuePart),
    )| FieldChange {
        field: field_name(attribute).to_owned(),
        old: text(attribute, old, is_written.old),
        new: text(attribute, new, is_written.new),
    };
    differing.map(change).collect()
}
