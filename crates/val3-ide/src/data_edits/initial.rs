//! Initial field values of user types.

use val3_analysis::db::{Db, Project};
use val3_analysis::items::project::data_files;
use val3_analysis::items::{data, parse};
use val3_data::{SavedContainer, SavedContent, SavedData, SavedField, SavedValue, is_same};

use crate::access::is_public;

/// Fields of a new value of the user type that `owner` declares.
pub(super) fn fields(db: &dyn Db, owner: Project) -> Vec<SavedField> {
    let mut fields = Vec::new();
    for file in data_files(db, owner) {
        let parse = parse(db, *file);
        let public = data::elements(parse.view()).filter(|element| is_public(*element));
        fields.extend(public.map(|element| SavedField { initial: true, data: val3_data::read(element) }));
    }
    fields
}

/// Adds the missing fields of a value, and marks fields that have their initial value.
pub(super) fn complete(value: &mut SavedValue, initial: &[SavedField]) {
    let SavedContent::Fields(fields) = &mut value.content else { return };
    for known in initial {
        match fields.iter_mut().find(|field| field.data.name == known.data.name) {
            Some(field) => field.initial = is_same_data(&field.data, &known.data),
            None => fields.push(known.clone()),
        }
    }
}

fn is_same_data(one: &SavedData, other: &SavedData) -> bool {
    one.shape == other.shape
        && (one.shape != SavedContainer::Keys || one.values.len() == other.values.len())
        && has_values_of(other, one)
        && has_values_of(one, other)
}

/// Whether all values of `other` are the same in `data`.
fn has_values_of(data: &SavedData, other: &SavedData) -> bool {
    other.values.iter().all(|value| {
        let own = data.values.iter().find(|own| own.key == value.key);
        is_same_value(&other.type_name, Some(value), own)
    })
}

fn is_same_value(type_name: &str, one: Option<&SavedValue>, other: Option<&SavedValue>) -> bool {
    match (one.map(|value| &value.content), other.map(|value| &value.content)) {
        (Some(SavedContent::Fields(one)), Some(SavedContent::Fields(other))) => {
            one.len() == other.len()
                && one
                    .iter()
                    .zip(other)
                    .all(|(one, other)| one.data.name == other.data.name && is_same_data(&one.data, &other.data))
        }
        (Some(SavedContent::Fields(_)), None) | (None, Some(SavedContent::Fields(_))) => false,
        _ => is_same(type_name, one, other),
    }
}
