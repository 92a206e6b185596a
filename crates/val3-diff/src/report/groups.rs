//! Groups of array elements with the same change, which share a line.

use rustc_hash::FxHashMap;

use super::changes::fields;
use super::elements::parts;
use crate::model::{Change, FieldChange, ValueChange};

/// Minimum number of elements that share a line. Fewer elements are shown individually.
const FEWEST: usize = 3;

/// Returns the values in groups, ordered by the first value in each group.
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
    groups.into_iter().flat_map(split_if_small).collect()
}

/// Returns the values of a small group one by one.
fn split_if_small(group: Vec<&ValueChange>) -> Vec<Vec<&ValueChange>> {
    if group.len() < FEWEST { group.into_iter().map(|value| vec![value]).collect() } else { vec![group] }
}

/// Returns a description of the change that is equal for all values in a group.
fn kind(value: &ValueChange) -> String {
    match (value.change, value.movement.and_then(|movement| movement.shift)) {
        (Change::Changed, Some(shift)) => {
            format!("{:?} {:?} {}", shift.translation_mm, shift.rotation_deg, fields(&other_fields(value)))
        }
        (Change::Changed, None) => fields(&value.fields),
        (change, _) => format!("{change:?} {}", value.value.as_deref().unwrap_or_default()),
    }
}

/// Returns the fields without the numbers of the pose, which differ between positions with the same movement.
pub(super) fn other_fields(value: &ValueChange) -> Vec<FieldChange> {
    value.fields.iter().filter(|change| !change.is_of_pose()).cloned().collect()
}
