//! Values of attributes.

use smol_str::SmolStr;
use val3_analysis::db::Project;
use val3_analysis::items::project::{DataItem, fields, items, program_files, resolve_type};
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::Base;
use val3_lang::enumerations;
use val3_lang::files::{self, FileKind, Presence};
use val3_lang::types::{AttributeValue, BaseType, attribute};

use super::fathers::fathers;
use super::keys::{self, initial};
use super::names::{self, files as folder_files};
use val3_syntax::xml::escaped;

use crate::completion::list::{CompletionKind as Kind, CompletionList};
use crate::completion::names::{FITS, data_detail};
use crate::declare::old_data;
use crate::io_links::{io_links, linked_type};
use crate::reachable_projects::reachable;
use crate::xml_context::XmlContext;

/// Possible values for an attribute.
pub(super) fn values(found: &mut CompletionList<'_>, context: &XmlContext<'_>, name: &str) {
    let element = context.cursor.tag.as_ref().map_or("", |tag| tag.name);
    match context.file {
        FileKind::Project => of_project(found, context, element, name),
        FileKind::Program => of_program(found, element, name),
        FileKind::Data => of_data(found, context, element, name),
    }
    known_values(found, context, element, name);
}

fn add(found: &mut CompletionList<'_>, text: &str, kind: Kind, detail: &str, score: i32) {
    if !found.items.iter().any(|item| item.label == text) {
        found.add(text, kind).detail(|| detail.to_owned()).scored(score);
    }
}

/// Adds texts, given in order of probability.
fn add_all(found: &mut CompletionList<'_>, texts: impl IntoIterator<Item = impl AsRef<str>>, kind: Kind, detail: &str) {
    for (place, text) in (0..).zip(texts) {
        add(found, text.as_ref(), kind, detail, -place);
    }
}

/// Values that the file format defines for an attribute: its keywords, default and namespace.
fn known_values(found: &mut CompletionList<'_>, context: &XmlContext<'_>, element: &str, name: &str) {
    let Some(known) = files::find(context.file, element) else { return };
    if let Some(namespace) = known.namespace.filter(|_| name == "xmlns") {
        add(found, namespace, Kind::Keyword, "namespace", 0);
    }
    let Some(attribute) = known.attribute(name) else { return };
    add_all(found, attribute.values, Kind::Keyword, "");
    match attribute.presence {
        Presence::Expected(default) | Presence::Optional(default) if !default.is_empty() => {
            add(found, default, Kind::Keyword, "default", -10);
        }
        _ => {}
    }
}

fn of_project(found: &mut CompletionList<'_>, context: &XmlContext<'_>, element: &str, name: &str) {
    match (element, name) {
        (_, "version") => {
            let versions = names::versions(found.db, found.project);
            add_all(found, versions, Kind::Constant, "version");
        }
        (_, "stackSize") => add_all(found, ["5000", "10000", "20000", "50000"], Kind::Constant, "bytes"),
        ("Program" | "program", "file") => files_of(found, ".pgx"),
        ("Data" | "data", "file") => files_of(found, ".dtx"),
        ("Library", "alias") | ("Type" | "alias", "name") => {
            let path = context.cursor.tag.as_ref().and_then(|tag| tag.value("path").or(tag.value("interface")));
            let aliases = names::aliases(found, path);
            let unused = aliases.into_iter().filter(|alias| !context.cursor.has_sibling_with(name, alias));
            add_all(found, unused, Kind::Library, "");
        }
        ("Library" | "Type", "path") | ("alias", "interface") => projects(found, element == "Type"),
        _ => {}
    }
}

/// Files in the project folder; files that the project does not list come first.
fn files_of(found: &mut CompletionList<'_>, extension: &str) {
    for (name, is_listed) in folder_files(found, extension) {
        add(found, &name, Kind::Path, "", if is_listed { 0 } else { FITS });
    }
}

/// Projects that can be referenced; projects that the project file does not reference yet come first. A user type has
/// data and rarely programs.
fn projects(found: &mut CompletionList<'_>, is_type: bool) {
    let (db, project) = (found.db, found.project);
    let named = names::named(db, project);
    for other in reachable(db, project) {
        let is_new = if named.contains(&other.project) { 0 } else { FITS };
        let offered = items(db, other.project);
        let suits = offered.programs.is_empty() == is_type && !offered.data.is_empty();
        let score = is_new + if suits { FITS / 2 } else { 0 };
        add(found, &other.entry(db, project), Kind::Path, "", score);
    }
}

fn of_program(found: &mut CompletionList<'_>, element: &str, name: &str) {
    match (element, name) {
        ("Program" | "program", "name") => {
            let stem = names::stem(found.db, found.file);
            add_all(found, stem, Kind::Program, "as the file");
        }
        ("Parameter" | "Local" | "param" | "local", "name") => {
            let unknown = names::undeclared(found, &[found.file]);
            add_all(found, unknown, Kind::Local, "used and not declared");
        }
        (_, "type") => types(found, false),
        _ => {}
    }
}

fn of_data(found: &mut CompletionList<'_>, context: &XmlContext<'_>, element: &str, name: &str) {
    let is_old = context.cursor.open.first().is_some_and(|root| root.name == "dataList");
    match (element, name) {
        ("Data", "name") => unknown_data(found),
        ("Field", "name") => user_fields(found, context),
        ("Field", "type") => field_type(found, context),
        ("Field", "size") => field_size(found, context),
        (_, "type") => types(found, true),
        (_, "key" | "index") => {
            let keys = keys::free(found, context);
            add_all(found, keys, Kind::Text, "");
        }
        (_, "fatherId") => fathers(found, context, false),
        (_, "name") if element.ends_with("Father") => fathers(found, context, true),
        (_, "name") if is_old && context.parent().ends_with("Section") => unknown_data(found),
        ("io", "name") => outputs(found),
        (_, "alias") if is_old => {
            let mut aliases: Vec<SmolStr> = items(found.db, found.project).libraries.keys().cloned().collect();
            aliases.sort_unstable();
            add_all(found, aliases, Kind::Library, "");
        }
        _ => {}
    }
    value_attribute(found, context, name);
    if is_old {
        old_default(found, context, element, name);
    }
}

/// Undeclared variable names that programs use.
fn unknown_data(found: &mut CompletionList<'_>) {
    let unknown = names::undeclared(found, program_files(found.db, found.project));
    add_all(found, unknown, Kind::Data, "used and not declared");
}

/// Types. Position types include the arm kind in data files, but not in program headers.
fn types(found: &mut CompletionList<'_>, is_data: bool) {
    let (db, project) = (found.db, found.project);
    let items = items(db, project);
    let arm = items.arm.filter(|_| is_data);
    // The most common types come first.
    let common = [BaseType::Num, BaseType::Bool, BaseType::String, BaseType::Point, BaseType::Dio];
    let rest = BaseType::DECLARABLE.into_iter().filter(|ty| !common.contains(ty));
    for (place, ty) in (0..).zip(common.into_iter().chain(rest)) {
        let name = arm.map_or_else(|| ty.name().to_owned(), |arm| ty.file_name(arm));
        found.add(&name, Kind::Type).scored(-place).of(|| Symbol::BuiltinType(name.as_str().into()));
    }
    for name in items.types.keys() {
        let added = found.add(name, Kind::Type).detail(|| "user type".to_owned());
        added.of(|| Symbol::Type(project, name.clone()));
    }
}

/// User type whose fields are edited: the type of the next outer declaration.
fn owner_of_field(found: &CompletionList<'_>, context: &XmlContext<'_>) -> Option<Project> {
    let types = &items(found.db, found.project).types;
    let mut outer = context.declarations().filter(|(tag, _)| Some(*tag) != context.cursor.tag.as_ref());
    match resolve_type(types, outer.next()?.0.value("type")?)? {
        Base::User(project) => Some(project),
        _ => None,
    }
}

fn user_fields(found: &mut CompletionList<'_>, context: &XmlContext<'_>) {
    let Some(owner) = owner_of_field(found, context) else { return };
    let taken = |name: &str| context.cursor.siblings.iter().any(|other| other.value("name") == Some(name));
    for (name, item) in fields(found.db, owner) {
        let score = if taken(name) { -FITS } else { 0 };
        let added = found.add(name, Kind::Field).detail(|| data_detail(item)).scored(score);
        added.of(|| Symbol::Data(owner, name.clone()));
    }
}

/// Declaration of the field that the tag names.
fn declared_field(found: &CompletionList<'_>, context: &XmlContext<'_>) -> Option<DataItem> {
    let name = context.cursor.tag.as_ref()?.value("name")?;
    fields(found.db, owner_of_field(found, context)?).get(name).cloned()
}

fn field_type(found: &mut CompletionList<'_>, context: &XmlContext<'_>) {
    match declared_field(found, context) {
        Some(field) => add(found, &field.decl.type_name, Kind::Type, "as the type declares it", FITS),
        None => types(found, true),
    }
}

fn field_size(found: &mut CompletionList<'_>, context: &XmlContext<'_>) {
    if let Some(field) = declared_field(found, context) {
        let sizes: Vec<String> = field.decl.sizes.iter().map(u32::to_string).collect();
        add(found, &sizes.join(" "), Kind::Text, "as the type declares it", FITS);
    }
}

/// Possible values of this attribute for a value of the surrounding type.
fn value_attribute(found: &mut CompletionList<'_>, context: &XmlContext<'_>, name: &str) {
    let Some((ty, arm)) = context.builtin(found.db, found.project) else { return };
    let Some(known) = attribute(ty, arm, name) else { return };
    match known.value {
        AttributeValue::Truth => add_all(found, ["true", "false"], Kind::Keyword, ""),
        AttributeValue::Choice(choice) => {
            let names: Vec<&str> = enumerations::values(choice).map(|value| value.file_name).collect();
            add_all(found, names, Kind::Keyword, "");
        }
        AttributeValue::Link => links(found, ty),
        AttributeValue::Number => add(found, &initial(known), Kind::Constant, "default", 0),
        AttributeValue::Text | AttributeValue::Father(_) => {}
    }
}

/// Attribute default in s5 and s6.
fn old_default(found: &mut CompletionList<'_>, context: &XmlContext<'_>, element: &str, name: &str) {
    let Some(ty) = context.types().next() else { return };
    let default = old_data::attributes(ty, element).into_iter().find(|(known, _)| known == name);
    if let Some((_, value)) = default.filter(|(_, value)| !value.is_empty() && name != "name") {
        add(found, &value, Kind::Constant, "default", 0);
    }
}

/// Inputs and outputs of the cell with this type.
fn links(found: &mut CompletionList<'_>, ty: BaseType) {
    let wanted = linked_type(ty);
    for link in io_links(found.db, found.project, ty) {
        let score = if link.is_usual { 0 } else { -FITS };
        add(found, &escaped(&link.path), Kind::Path, wanted.name(), score);
    }
}

/// Digital outputs that a tool of s5 and s6 can reference.
fn outputs(found: &mut CompletionList<'_>) {
    let data = &items(found.db, found.project).data;
    let outputs = data.iter().filter(|(_, item)| item.base == Base::of(BaseType::Dio));
    let mut names: Vec<SmolStr> = outputs.map(|(name, _)| name.clone()).collect();
    names.sort_unstable();
    add_all(found, names, Kind::Data, "dio");
}
