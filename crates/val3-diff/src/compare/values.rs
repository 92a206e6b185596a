//! Comparison of data values.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::placement::shown;
use val3_syntax::TextSlice;

use super::placement::Places;
use super::{fields, movement, renumbering};
use crate::model::ReportClass;
use crate::model::{Change, FieldChange, Renumbering, ValueChange, ValuePair};
use crate::read::data::DataVersion;
use crate::read::value::FileValue;

/// Returns the values that differ, in the order of the new file, followed by removed values; and the renumbering.
pub(super) fn compare(
    old: &DataVersion,
    new: &DataVersion,
    places: &mut Places<'_>,
) -> (Vec<ValueChange>, Option<Renumbering>) {
    let Some(found) = renumbering::find(old, new, places) else { return (by_index(old, new, places), None) };
    let mut changes = some(old, &found.removed, Change::Removed);
    changes.extend(some(new, &found.inserted, Change::Added));
    changes.extend(by_index(&found.old, &found.new, places));
    (changes, Some(found.renumbering))
}

/// Returns the values that differ between elements with the same index or key.
fn by_index(old: &DataVersion, new: &DataVersion, places: &mut Places<'_>) -> Vec<ValueChange> {
    let (old_values, new_values) = (values_by_path(old), values_by_path(new));
    let gone = old.values.iter().filter(|(path, _)| !new_values.contains_key(path));
    let mut changes = elements(old, new);
    for (path, _) in new.values.iter().chain(gone) {
        let key = key(&new.decl.name, path);
        if !is_in_both(old, new, key) {
            continue;
        }
        let (old_value, new_value) = (old_values.get(path), new_values.get(path));
        changes.extend(compare_one(path, old_value.copied().cloned(), new_value.copied().cloned(), places));
    }
    changes.extend(field_sizes(old, new));
    changes
}

fn values_by_path(data: &DataVersion) -> FxHashMap<&SmolStr, &FileValue> {
    data.values.iter().map(|(path, value)| (path, value)).collect()
}

/// Whether the element is in both data, or both files contain it outside of the size.
fn is_in_both(old: &DataVersion, new: &DataVersion, key: &str) -> bool {
    match (old.has_element(key), new.has_element(key)) {
        (true, true) => true,
        (false, false) => old.keys.contains(key) && new.keys.contains(key),
        _ => false,
    }
}

/// Returns fields of user types with different sizes in both files. An omitted size is the size in the type.
fn field_sizes(old: &DataVersion, new: &DataVersion) -> impl Iterator<Item = ValueChange> {
    let sizes = new.field_sizes.iter().filter_map(|(path, size)| Some((path, old.field_sizes.get(path)?, size)));
    sizes.filter(|(_, old, new)| old != new).map(|(path, old, new)| ValueChange {
        path: shown(path),
        change: Change::Changed,
        class: ReportClass::Data,
        type_name: String::new(),
        value: None,
        movement: None,
        axes: None,
        fields: vec![FieldChange { field: "size".to_owned(), old: Some(old.clone()), new: Some(new.clone()) }],
        dependents: Vec::new(),
    })
}

/// Returns the key of the element at the start of a path: `a b` for `tSlot[a b].pPick[1]`.
pub(super) fn key<'p>(name: &str, path: &'p str) -> &'p str {
    let rest = path.strip_prefix(name).unwrap_or(path);
    let rest = rest.strip_prefix('[').unwrap_or(rest);
    rest.split_once(']').map_or(rest, |(key, _)| key)
}

/// Compares a value. A missing value is the type's default; for a field, the value in the user type.
fn compare_one(
    path: &SmolStr,
    old: Option<FileValue>,
    new: Option<FileValue>,
    places: &mut Places<'_>,
) -> Option<ValueChange> {
    let known = new.as_ref().or(old.as_ref())?;
    let (ty, arm) = (known.ty, known.arm);
    let default = FileValue::default_of(ty, arm);
    let is_field = path.contains("].");
    let is_written = ValuePair { old: old.is_some() || !is_field, new: new.is_some() || !is_field };
    let (old, new) = (old.unwrap_or_else(|| default.clone()), new.unwrap_or(default));
    let are_known = is_written.old && is_written.new;
    let fields = fields::compare(&old, &new, is_written);
    if fields.is_empty() {
        return None;
    }
    Some(ValueChange {
        path: shown(path),
        change: Change::Changed,
        class: ReportClass::of(Some(ty)),
        type_name: ty.name().to_owned(),
        value: None,
        movement: if are_known { movement::of(path, &old, &new, places) } else { None },
        axes: movement::of_axes(&old, &new, places),
        fields,
        dependents: Vec::new(),
    })
}

/// Returns elements that are in only one of the sizes or key sets, and that have a value or key in the file.
fn elements(old: &DataVersion, new: &DataVersion) -> Vec<ValueChange> {
    [elements_only_in(old, new, Change::Removed), elements_only_in(new, old, Change::Added)].concat()
}

fn elements_only_in(data: &DataVersion, other: &DataVersion, change: Change) -> Vec<ValueChange> {
    let contents = Contents::of(data);
    let keys = data.keys.iter().filter(|key| is_only_in(data, other, key));
    keys.map(|key| contents.element(data, key, change)).collect()
}

/// Whether the element is missing in `other`. An element outside of both sizes is not missing if `other` has its key.
fn is_only_in(data: &DataVersion, other: &DataVersion, key: &str) -> bool {
    let is_outside_of_both = !data.has_element(key) && other.keys.contains(key);
    !other.has_element(key) && !is_outside_of_both
}

/// Returns all elements in the file, for data that exist in only one tree.
pub(super) fn all(data: &DataVersion, change: Change) -> Vec<ValueChange> {
    let contents = Contents::of(data);
    data.keys.iter().map(|key| contents.element(data, key, change)).collect()
}

/// Returns the elements with these indexes, for data that exist in only one tree.
fn some(data: &DataVersion, indexes: &[usize], change: Change) -> Vec<ValueChange> {
    let contents = Contents::of(data);
    indexes.iter().map(|index| contents.element(data, &index.to_string(), change)).collect()
}

/// Non-default values and user type fields in the file, by element key.
pub(super) struct Contents<'d>(FxHashMap<&'d str, Vec<String>>);

impl<'d> Contents<'d> {
    /// Returns the contents of data.
    pub(super) fn of(data: &'d DataVersion) -> Self {
        let name = &data.decl.name;
        let mut contents: FxHashMap<&str, Vec<String>> = FxHashMap::default();
        for (path, value) in &data.values {
            let Some(value) = value.shown() else { continue };
            let key = key(name, path);
            // Skips the name, the key and its brackets.
            let field = path.part(name.len() + key.len() + 2..).trim_start_matches('.');
            let text = if field.is_empty() { value } else { format!("{} {value}", shown(field)) };
            contents.entry(key).or_default().push(text);
        }
        Self(contents)
    }

    /// Returns the texts of the element with this key; `None` for an element with default values.
    pub(super) fn get(&self, key: &str) -> Option<&[String]> {
        self.0.get(key).map(Vec::as_slice)
    }

    fn element(&self, data: &DataVersion, key: &str, change: Change) -> ValueChange {
        let ty = data.base.map(|(ty, _)| ty);
        let mut texts = self.get(key).unwrap_or_default().to_vec();
        texts.extend((!data.has_element(key)).then(|| "outside of the size".to_owned()));
        ValueChange {
            path: shown(&format!("{}[{key}]", data.decl.name)),
            change,
            class: ReportClass::of(ty),
            type_name: ty.map_or_else(|| data.type_name().to_owned(), |ty| ty.name().to_owned()),
            value: (!texts.is_empty()).then(|| texts.join("; ")),
            fields: Vec::new(),
            movement: None,
            axes: None,
            dependents: Vec::new(),
        }
    }
}
