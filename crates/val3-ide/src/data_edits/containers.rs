//! Sizes of arrays and keys of collections.

use rustc_hash::FxHashSet;
use val3_analysis::ty::Base;
use val3_analysis::xml::XmlElement;
use val3_data::{SavedContainer, SavedContent, SavedData, SavedValue};
use val3_lang::types::BaseType;
use val3_syntax::TextEdit;

use super::edit::refusal;
use super::target::{DataFile, check_text};
use super::walk;
use crate::data_tables::{DataPlace, DataProblem, Dialect};
use crate::declare::{built_in_father, keys};

/// Changes array sizes.
pub(super) fn resize(file: &DataFile<'_>, place: &DataPlace, sizes: &[u32]) -> Result<Vec<TextEdit>, DataProblem> {
    file.check_sizes(sizes)?;
    change(file, place, |data, base| {
        let SavedContainer::Sizes(old) = &data.shape else {
            return Err(refusal(format!("`{}` is a collection: it has keys and no size", data.name)));
        };
        let old = old.clone();
        if old.len() != sizes.len() {
            data.values.iter_mut().for_each(|value| value.key = with_dimensions(&value.key, sizes.len()));
        }
        let fits = |key: &str| fits(sizes, key);
        data.values.retain(|value| fits(&value.key));
        data.shape = SavedContainer::Sizes(sizes.to_vec());
        add_fathers(file, data, base, &old);
        Ok(())
    })
}

/// Adapts a key to another number of dimensions. Added dimensions have the index 0. A removed dimension must have the
/// index 0, otherwise the value is removed.
fn with_dimensions(key: &str, dimensions: usize) -> String {
    let mut indexes: Vec<&str> = key.split(',').map(str::trim).collect();
    while indexes.len() < dimensions {
        indexes.push("0");
    }
    while indexes.len() > dimensions && indexes.last() == Some(&"0") {
        indexes.pop();
    }
    indexes.join(",")
}

fn fits(sizes: &[u32], key: &str) -> bool {
    let indexes: Vec<Option<u32>> = key.split(',').map(|index| index.trim().parse().ok()).collect();
    indexes.len() == sizes.len()
        && indexes.iter().zip(sizes).all(|(index, size)| index.is_some_and(|index| index < *size))
}

/// Adds the father to new points, frames and tools. In s5 and s6, the father belongs to the variable.
fn add_fathers(file: &DataFile<'_>, data: &mut SavedData, base: Base, old: &[u32]) {
    let Some(father) = father(base).filter(|_| file.dialect == Dialect::New) else { return };
    let SavedContainer::Sizes(sizes) = &data.shape else { return };
    let known: FxHashSet<String> = data.values.iter().map(|value| value.key.clone()).collect();
    let missing = keys(sizes).into_iter().filter(|key| !known.contains(key));
    let new = missing.filter(|key| old.len() != sizes.len() || !fits(old, key));
    data.values.extend(new.map(|key| SavedValue { key, content: father.clone() }));
}

/// Default father of a new point, frame or tool, as file content.
fn father(base: Base) -> Option<SavedContent> {
    let name = built_in_father(base.builtin().map_or("", BaseType::name))?;
    Some(SavedContent::Attributes(vec![("fatherId".into(), format!("{name}[0]"))]))
}

/// Adds an element to a collection.
pub(super) fn add_key(file: &DataFile<'_>, place: &DataPlace, key: &str) -> Result<Vec<TextEdit>, DataProblem> {
    check_key(key)?;
    change(file, place, |data, base| {
        check_collection(data)?;
        check_key_unused(data, key)?;
        let content = father(base).unwrap_or_else(|| SavedContent::Attributes(Vec::new()));
        data.values.push(SavedValue { key: key.to_owned(), content });
        Ok(())
    })
}

/// Removes elements from a collection.
pub(super) fn remove_keys(
    file: &DataFile<'_>,
    place: &DataPlace,
    keys: &[String],
) -> Result<Vec<TextEdit>, DataProblem> {
    change(file, place, |data, _| {
        check_collection(data)?;
        keys.iter().try_for_each(|key| check_key_exists(data, key))?;
        data.values.retain(|value| !keys.contains(&value.key));
        Ok(())
    })
}

/// Renames a key in a collection.
pub(super) fn rename_key(
    file: &DataFile<'_>,
    place: &DataPlace,
    key: &str,
    new_key: &str,
) -> Result<Vec<TextEdit>, DataProblem> {
    check_key(new_key)?;
    let element = element_at(file, place)?;
    let data = val3_data::read(element);
    check_collection(&data)?;
    check_key_exists(&data, key)?;
    if key != new_key {
        check_key_unused(&data, new_key)?;
    }
    let value = element.elements().find(|value| value.value("key").as_deref() == Some(key));
    Ok(value.and_then(|value| val3_data::rename_key(value, new_key)).into_iter().collect())
}

/// XML element of a variable or of a field inside it.
fn element_at<'a>(file: &DataFile<'a>, place: &DataPlace) -> Result<XmlElement<'a>, DataProblem> {
    let mut element = file.element(&place.name)?;
    let mut key = place.key.as_deref().unwrap_or("");
    for step in &place.within {
        let value = element.elements().find(|value| value.value("key").as_deref() == Some(key));
        let field = value.and_then(|value| {
            value.elements().find(|field| field.value("name").as_deref() == Some(step.name.as_str()))
        });
        element = field.ok_or_else(|| refusal(format!("the file writes no field `{}` there", step.name)))?;
        key = &step.key;
    }
    Ok(element)
}

/// Edits after which the container at a place has the state that `alter` produces.
fn change(
    file: &DataFile<'_>,
    place: &DataPlace,
    alter: impl FnOnce(&mut SavedData, Base) -> Result<(), DataProblem>,
) -> Result<Vec<TextEdit>, DataProblem> {
    let mut data = val3_data::read(file.element(&place.name)?);
    let found = walk::container(file, &mut data, place)?;
    alter(found.data, found.base)?;
    walk::mark_initial(file, &mut data);
    Ok(val3_data::edits(file.text, file.root, &[data]))
}

fn check_key(key: &str) -> Result<(), DataProblem> {
    if key.is_empty() {
        return Err(refusal("a key is a text that is not empty"));
    }
    if key.contains('"') {
        return Err(refusal("a key with a quote cannot be written in programs"));
    }
    check_text(key)
}

/// Checks that the data has keys, and no sizes.
fn check_collection(data: &SavedData) -> Result<(), DataProblem> {
    match data.shape {
        SavedContainer::Keys => Ok(()),
        SavedContainer::Sizes(_) => Err(refusal(format!("`{}` is an array: it has a size and no keys", data.name))),
    }
}

fn check_key_unused(data: &SavedData, key: &str) -> Result<(), DataProblem> {
    if has_key(data, key) {
        return Err(refusal(format!("`{}` has the key `{key}` already", data.name)));
    }
    Ok(())
}

fn check_key_exists(data: &SavedData, key: &str) -> Result<(), DataProblem> {
    if !has_key(data, key) {
        return Err(refusal(format!("`{}` has no key `{key}`", data.name)));
    }
    Ok(())
}

fn has_key(data: &SavedData, key: &str) -> bool {
    data.values.iter().any(|value| value.key == key)
}
