//! Completions in the XML of a file: the values of attributes.

use val3_analysis::items::manifest::manifest;
use val3_analysis::items::project::{fields, items, resolve_type};
use val3_analysis::ty::Base;
use val3_lang::types::{AttributeValue, BaseType, attribute};
use val3_lang::{builtins, enumerations};

use super::missing::entry;
use super::names::data_detail;
use super::reach::reachable;
use super::xml_place::AttributePlace;
use super::{CompletionKind as Kind, Found};

/// What can stand in an attribute.
pub(super) fn values(found: &mut Found<'_>, place: &AttributePlace) {
    match (place.element.as_str(), place.attribute.as_str()) {
        ("Parameter" | "Local" | "Data" | "Field" | "param" | "local", "type") => types(found, &place.element),
        (_, "access") => words(found, &["public", "private"]),
        ("Parameter", "xsi:type") => words(found, &["element", "array", "collection"]),
        (_, "xsi:type") => words(found, &["array", "collection"]),
        (_, "use") => words(found, &["value", "reference"]),
        (_, "autoload" | "byVal" | "public" | "millimeterUnit") => words(found, &["true", "false"]),
        (_, "fatherId") => fathers(found, place, "[0]"),
        (element, "name") if element.ends_with("Father") => fathers(found, place, ""),
        ("Program" | "program", "file") => files(found, ".pgx"),
        ("Data" | "data", "file") => files(found, ".dtx"),
        ("Library" | "Type" | "alias", "path" | "interface") => projects(found),
        ("Field", "name") => user_fields(found, place),
        _ => value_attribute(found, place),
    }
}

fn words(found: &mut Found<'_>, words: &[&str]) {
    for (index, word) in (0..).zip(words) {
        found.add(word, Kind::Keyword).scored(-index);
    }
}

/// Data files name the arm of positions, headers of programs do not.
fn types(found: &mut Found<'_>, element: &str) {
    let items = items(found.db, found.project);
    let arm = items.arm.filter(|_| matches!(element, "Data" | "Field"));
    for (place, ty) in (0..).zip(BaseType::DECLARABLE) {
        let name = arm.map_or_else(|| ty.name().to_owned(), |arm| ty.file_name(arm));
        found.add(&name, Kind::Type).scored(-place);
    }
    let project = found.project;
    for name in items.types.keys() {
        let added = found.add(name, Kind::Type).detail(|| "user type".to_owned());
        added.of(|| val3_analysis::occurrences::Symbol::Type(project, name.clone()));
    }
}

/// Frames for points and frames, tools for tools.
fn fathers(found: &mut Found<'_>, place: &AttributePlace, index: &str) {
    let ty = place.data_type.as_deref().and_then(BaseType::from_file_name).map(|(ty, _)| ty);
    let Some(father) = ty.and_then(BaseType::father) else { return };
    for (name, item) in &items(found.db, found.project).data {
        if item.base == Base::of(father) {
            found.add(&format!("{name}{index}"), Kind::Data).detail(|| data_detail(item));
        }
    }
    for builtin in builtins::BUILTINS.iter().filter(|builtin| builtin.ty == father && builtin.is_variable) {
        found.add(&format!("{}{index}", builtin.name), Kind::Constant).detail(|| father.name().to_owned());
    }
}

/// The files of the project's folder that its list does not name yet come first.
fn files(found: &mut Found<'_>, extension: &str) {
    let (db, project) = (found.db, found.project);
    let manifest = manifest(db, project.manifest(db));
    let is_listed =
        |name: &str| manifest.programs.iter().chain(&manifest.data).any(|listed| listed.eq_ignore_ascii_case(name));
    for name in project.beside(db).iter().filter(|name| name.to_ascii_lowercase().ends_with(extension)) {
        let score = if is_listed(name) { 0 } else { super::names::FITS };
        found.add(name, Kind::Path).scored(score);
    }
}

/// The projects that can be named here, those first that the project file does not name yet.
fn projects(found: &mut Found<'_>) {
    let (db, project) = (found.db, found.project);
    let named: Vec<_> = items(db, project).libraries.values().filter_map(|library| library.interface).collect();
    for other in reachable(db, project) {
        let score = if named.contains(&other.project) { 0 } else { super::names::FITS };
        found.add(&entry(db, project, &other), Kind::Path).scored(score);
    }
}

/// The fields of the user type of the data or field around.
fn user_fields(found: &mut Found<'_>, place: &AttributePlace) {
    let items = items(found.db, found.project);
    // A `<Field>` states the type of its own value; that of the owner is further out.
    let owners = [place.data_type.as_deref(), place.outer_type.as_deref()];
    let owner = owners.into_iter().flatten().find_map(|name| match resolve_type(&items.types, name) {
        Some(Base::User(project)) => Some(project),
        _ => None,
    });
    for (name, item) in owner.into_iter().flat_map(|project| fields(found.db, project)) {
        found.add(name, Kind::Field).detail(|| data_detail(item));
    }
}

/// Words that the attribute of a value takes.
fn value_attribute(found: &mut Found<'_>, place: &AttributePlace) {
    let Some((ty, arm)) = place.data_type.as_deref().and_then(BaseType::from_file_name) else { return };
    match attribute(ty, arm, &place.attribute).map(|attribute| attribute.value) {
        Some(AttributeValue::Truth) => words(found, &["true", "false"]),
        Some(AttributeValue::Choice(choice)) => {
            let names: Vec<&str> = enumerations::values(choice).map(|value| value.file_name).collect();
            words(found, &names);
        }
        Some(AttributeValue::Link) => links(found, if ty == BaseType::Tool { BaseType::Dio } else { ty }),
        _ => {}
    }
}

/// The inputs and outputs of the cell that have this type.
fn links(found: &mut Found<'_>, ty: BaseType) {
    let Some(cell) = found.project.cell(found.db) else { return };
    for (device, channels) in &cell.config(found.db).io {
        for (name, _) in channels.iter().filter(|(_, kind)| **kind == ty) {
            found.add(&format!("{device}\\{name}"), Kind::Path).detail(|| ty.name().to_owned());
        }
    }
}
