//! Elements of an array that changed in the same way, which share a line.

use rustc_hash::FxHashMap;

use super::changes::fields;
use super::elements::parts;
use crate::model::{Change, FieldChange, ValueChange};

/// Number of elements from which a line is shared. Fewer are shown with their own values.
const FEWEST: usize = 3;

/// The values in groups, in the order of the first value of each group.
pub(super) fn groups<'v>(values: &[&'v ValueChange]) -> Vec<Vec<&'v ValueChange>> {
    let mut groups: Vec<Vec<&ValueChange>> = Vec::new();
    let mut indexes: FxHashMap<(&str, &str, String), usize> = FxHashMap::default();
    for value in values {
        let (name, _, field) = parts(&value.path);
        let index = *indexes.entry((name, field, kind(value))).or_insert(groups.len());
        match groups.get_mut(index) {
            Some(group) => group.push(value),
            None => groups.push(vec![value]),
        }
    }
    let split = |group: Vec<&'v ValueChange>| -> Vec<Vec<&'v ValueChange>> {
        if group.len() < FEWEST { group.into_iter().map(|value| vec![value]).collect() } else { vec![group] }
    };
    groups.into_iter().flat_map(split).collect()
}

/// The change in words, which are equal for values of one group.
fn kind(value: &ValueChange) -> String {
    match (value.change, value.movement.and_then(|movement| movement.shift)) {
        (Change::Changed, Some(shift)) => {
            format!("{:?} {:?} {}", shift.translation_mm, shift.rotation_deg, fields(&other_fields(value)))
        }
        (Change::Changed, None) => fields(&value.fields),
        (change, _) => format!("{change:?} {}", value.value.as_deref().unwrap_or_default()),
    }
}

/// The fields without the numbers of the pose, which differ between positions with the same movement.
pub(super) fn other_fields(value: &ValueChange) -> Vec<FieldChange> {
    value.fields.iter().filter(|change| !change.is_of_pose()).cloned().collect()
}
