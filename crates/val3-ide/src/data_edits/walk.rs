//! Lookup of nested containers: from a variable to the container of a field inside it.

use val3_analysis::items::positions::key_of;
use val3_analysis::items::project::{fields, resolve_type};
use val3_analysis::ty::Base;
use val3_data::{SavedContainer, SavedContent, SavedData, SavedField, SavedValue};

use super::edit::refusal;
use super::initial;
use super::target::DataFile;
use crate::data_tables::{DataPlace, DataProblem, FieldStep};

/// A container within a variable, and its value type.
pub(super) struct FoundContainer<'d> {
    pub(super) data: &'d mut SavedData,
    pub(super) base: Base,
}

/// Container of a variable.
pub(super) fn variable<'d>(file: &DataFile<'_>, data: &'d mut SavedData) -> FoundContainer<'d> {
    let base = resolve_type(&file.items.types, &data.type_name).unwrap_or(Base::Unknown);
    FoundContainer { data, base }
}

/// Container at a place without a key: the variable, or the field at the end of the place. Values on this path that the
/// file omits are created with their initial values.
pub(super) fn container<'d>(
    file: &DataFile<'_>,
    data: &'d mut SavedData,
    place: &DataPlace,
) -> Result<FoundContainer<'d>, DataProblem> {
    let mut found = variable(file, data);
    let mut key = place.key.as_deref().unwrap_or("");
    for step in &place.within {
        found = field(file, found, key, step)?;
        key = &step.key;
    }
    Ok(found)
}

/// A field's container, in the value with this key.
fn field<'d>(
    file: &DataFile<'_>,
    found: FoundContainer<'d>,
    key: &str,
    step: &FieldStep,
) -> Result<FoundContainer<'d>, DataProblem> {
    let (base, at) = (found.base, position(found.data, key));
    field_of(file, base, value(file, found, key, at)?, step)
}

/// A field's container, in a value with the type `base`.
pub(super) fn field_of<'d>(
    file: &DataFile<'_>,
    base: Base,
    value: &'d mut SavedValue,
    step: &FieldStep,
) -> Result<FoundContainer<'d>, DataProblem> {
    let (Base::User(owner), SavedContent::Fields(known)) = (base, &mut value.content) else {
        return Err(refusal(format!("there is no field `{}`: the type is no user type of the project", step.name)));
    };
    let base = fields(file.db, owner).get(step.name.as_str()).map_or(Base::Unknown, |field| field.base);
    match known.iter_mut().find(|field| field.data.name == step.name.as_str()) {
        Some(field) => Ok(FoundContainer { data: &mut field.data, base }),
        None => Err(refusal(format!("the type has no field `{}`", step.name))),
    }
}

/// Value with this key, at the index `at` if it exists. A value that an array omits is added with its default.
pub(super) fn value<'d>(
    file: &DataFile<'_>,
    found: FoundContainer<'d>,
    key: &str,
    at: Option<usize>,
) -> Result<&'d mut SavedValue, DataProblem> {
    let FoundContainer { data, base } = found;
    let initial = file.initial_fields(base);
    if at.is_none() {
        check_key(data, key)?;
        let key = if data.shape == SavedContainer::Keys { key.to_owned() } else { key_of(key) };
        data.values.push(SavedValue { key, content: new_content(base, &initial) });
    }
    let at = at.unwrap_or(data.values.len().saturating_sub(1));
    let name = &data.name;
    let value = data.values.get_mut(at).ok_or_else(|| refusal(format!("`{name}` has no value `{key}`")))?;
    initial::complete(value, &initial);
    Ok(value)
}

/// Content of a new value.
fn new_content(base: Base, initial: &[SavedField]) -> SavedContent {
    match base {
        Base::User(_) => SavedContent::Fields(initial.to_vec()),
        _ => SavedContent::Attributes(Vec::new()),
    }
}

/// Index of the value with this key.
pub(super) fn position(data: &SavedData, key: &str) -> Option<usize> {
    let indexes = |key: &str| key.split(',').map(str::trim).map(str::to_owned).collect::<Vec<_>>();
    let is_array = data.shape != SavedContainer::Keys && key.contains([',', ' ']);
    let wanted = if is_array { indexes(key) } else { Vec::new() };
    data.values.iter().position(|value| value.key == key || is_array && indexes(&value.key) == wanted)
}

/// Checks that a value may be added under the key: an array may omit values, a collection must contain them.
fn check_key(data: &SavedData, key: &str) -> Result<(), DataProblem> {
    let name = &data.name;
    let SavedContainer::Sizes(sizes) = &data.shape else {
        return Err(refusal(format!("the collection `{name}` has no key `{key}`")));
    };
    let indexes: Option<Vec<u32>> = key.split(',').map(|index| index.trim().parse().ok()).collect();
    let fits = indexes.is_some_and(|indexes| {
        indexes.len() == sizes.len() && indexes.iter().zip(sizes).all(|(index, size)| index < size)
    });
    let sizes: Vec<String> = sizes.iter().map(u32::to_string).collect();
    match fits {
        true => Ok(()),
        false => Err(refusal(format!("`{name}` has no value `{key}`: its size is {}", sizes.join(" x ")))),
    }
}

/// Marks the fields that have their initial value, in all values of a variable.
pub(super) fn mark_initial(file: &DataFile<'_>, data: &mut SavedData) {
    let base = variable(file, data).base;
    if let Base::User(_) = base {
        let initial = file.initial_fields(base);
        data.values.iter_mut().for_each(|value| initial::complete(value, &initial));
    }
}
