//! Declaring, copying and removing variables, and changing their access.

use val3_data::{in_style, remove};
use val3_lang::types::{BaseType, Container};
use val3_syntax::TextEdit;

use super::edit::{NewDatum, refusal};
use super::target::DataFile;
use crate::access;
use crate::data_tables::{DataProblem, Dialect};
use crate::declare::{NewVariable, data_lines, data_list};

/// Declares a variable.
pub(super) fn add(file: &DataFile<'_>, new: &NewDatum) -> Result<Vec<TextEdit>, DataProblem> {
    file.check_new_name(&new.name)?;
    check_type(file, new)?;
    let variable = NewVariable {
        name: new.name.clone(),
        type_name: new.type_name.clone(),
        container: new.container,
        sizes: new.sizes.clone(),
    };
    let lines = data_lines(file.root.name(), &variable, None, new.public)
        .ok_or_else(|| refusal(format!("data of the type `{}` cannot be written in this file", new.type_name)))?;
    let lines = in_style(file.text, file.root, lines);
    // The preceding variable may have been removed in the meantime.
    let neighbour = new.after.as_deref().and_then(|name| file.element(name).ok());
    // In s5 and s6, each type has a section.
    let name = lines.first().and_then(|line| line.trim_start_matches('<').split(' ').next());
    if let Some(neighbour) = neighbour.filter(|element| name == Some(element.name())) {
        return Ok(vec![val3_data::after(file.text, file.root, neighbour, &lines)]);
    }
    let edit = data_list(file.text, file.root, &variable.type_name, &lines);
    let (range, text) = edit.ok_or_else(|| refusal("the file has no place for new data"))?;
    Ok(vec![TextEdit { range, text }])
}

fn check_type(file: &DataFile<'_>, new: &NewDatum) -> Result<(), DataProblem> {
    let name = &new.type_name;
    let built_in = BaseType::from_file_name(name);
    let is_user = file.items.types.contains_key(name.as_str()) && file.dialect == Dialect::New;
    // Position types in data files of s7 and s8 include the arm kind.
    let is_generic =
        built_in.is_some_and(|(ty, arm)| ty.depends_on_arm() && arm.is_none()) && file.dialect == Dialect::New;
    if built_in.is_none() && !is_user || is_generic {
        return Err(refusal(format!("there is no type `{name}` in this project")));
    }
    match new.container {
        Container::Collection if file.dialect == Dialect::Old || !file.items.version.has_collections() => {
            Err(refusal("there are no collections before s7"))
        }
        Container::Collection => Ok(()),
        Container::Array { .. } | Container::Element => file.check_sizes(&new.sizes),
    }
}

/// Declares a copy of a variable.
pub(super) fn duplicate(file: &DataFile<'_>, name: &str, new_name: &str) -> Result<Vec<TextEdit>, DataProblem> {
    let element = file.element(name)?;
    file.check_new_name(new_name)?;
    Ok(val3_data::duplicate(file.text, file.root, element, new_name).into_iter().collect())
}

/// Removes variables.
pub(super) fn delete(file: &DataFile<'_>, names: &[String]) -> Result<Vec<TextEdit>, DataProblem> {
    let elements: Result<Vec<_>, DataProblem> = names.iter().map(|name| file.element(name)).collect();
    Ok(remove(file.text, file.root, &elements?))
}

/// Changes the access of variables.
pub(super) fn access(file: &DataFile<'_>, names: &[String], public: bool) -> Result<Vec<TextEdit>, DataProblem> {
    let elements: Result<Vec<_>, DataProblem> = names.iter().map(|name| file.element(name)).collect();
    let changed = elements?.into_iter().filter(|element| access::is_public(*element) != public);
    let mut edits: Vec<TextEdit> = changed
        .filter_map(|element| access::set(file.text, element, public))
        .map(|(range, text)| TextEdit { range, text })
        .collect();
    edits.sort_by_key(|edit| edit.range.start());
    edits.dedup();
    Ok(edits)
}
