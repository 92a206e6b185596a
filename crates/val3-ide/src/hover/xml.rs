//! Hover for the XML of a file: elements, attributes, and the targets of paths.

use std::fmt::Write as _;

use val3_analysis::db::{Db, Project};
use val3_analysis::interfaces::{LoadedPath, uses};
use val3_analysis::items::data::data;
use val3_analysis::items::program::header;
use val3_analysis::items::project::{find_file, find_project, items};
use val3_lang::file_pages;
use val3_lang::files::{self, AttributePage, FileKind, Presence};
use val3_lang::instruction::Family;
use val3_lang::instructions;
use val3_lang::types::{self, Arm, AttributeValue, BaseType};
use val3_lang::versions::Version;
use val3_syntax::{TextRange, decode_entities, text_at};

use super::attributes::field_page;
use super::program_line;
use super::text::{Hover, place_of, shape};
use crate::FilePosition;
use crate::document_links::without_quotes;
use crate::markdown::{block, code, fenced};
use crate::xml_context::XmlContext;
use crate::xml_cursor::XmlPlace;

/// Limit of displayed interface items and instructions.
const SHOWN: usize = 12;

pub(super) fn hover(db: &dyn Db, project: Project, at: FilePosition) -> Option<Hover> {
    let (context, range) = XmlContext::at(db, at.file, at.offset)?;
    let tag = context.cursor.tag.as_ref();
    let markdown = match context.cursor.place {
        XmlPlace::Content(_) => None,
        XmlPlace::ElementName(_) => element(context.file, tag?.name),
        XmlPlace::EndTag(_) => element(context.file, slice(at.file.text(db), range)),
        XmlPlace::AttributeName(_) => attribute(db, project, &context, slice(at.file.text(db), range)),
        XmlPlace::Value(name, _) => {
            let value = tag?.value(name).map(decode_entities).unwrap_or_default();
            value_page(db, project, &context, name, &value).or_else(|| attribute(db, project, &context, name))
        }
    };
    Some(Hover { range, markdown: markdown? })
}

/// Hover for the path of a library that a program loads.
pub(super) fn loaded(db: &dyn Db, project: Project, at: FilePosition) -> Option<Hover> {
    let load = uses(db, at.file).loads.iter().find(|load| load.range.contains_inclusive(at.offset))?;
    let LoadedPath::Whole(path) = &load.path else { return None };
    let range = without_quotes(at.file.text(db), load.range);
    Some(Hover { range, markdown: project_page(db, project, path) })
}

fn slice(text: &str, range: TextRange) -> &str {
    text_at(text, range)
}

fn xml(text: &str) -> String {
    block("xml", text)
}

/// An element with its attributes.
fn element(file: FileKind, name: &str) -> Option<String> {
    let page = file_pages::element(file, name)?;
    let mut text = xml(&format!("<{name}>")) + &format!("\n{page}");
    let attributes = files::find(file, name).map_or(&[][..], |known| known.attributes);
    for (place, attribute) in attributes.iter().enumerate() {
        let page = file_pages::attribute(file, name, attribute.name).unwrap_or("");
        let start = if place == 0 { "\n\n" } else { "\n" };
        let _ = write!(text, "{start}- `{}`, {}. {page}", attribute.name, presence(attribute));
    }
    Some(text)
}

fn presence(attribute: &AttributePage) -> String {
    match attribute.presence {
        Presence::Required => "required".to_owned(),
        Presence::Expected(default) => format!("always written, `{default}` by default"),
        Presence::Optional("") => "optional, empty by default".to_owned(),
        Presence::Optional(default) => format!("optional, `{default}` by default"),
    }
}

/// An attribute of the tag at the cursor.
fn attribute(db: &dyn Db, project: Project, context: &XmlContext<'_>, name: &str) -> Option<String> {
    let element = context.cursor.tag.as_ref()?.name;
    let known = files::find(context.file, element).and_then(|known| known.attribute(name));
    if let Some(page) =
        file_pages::attribute(context.file, element, name).filter(|_| known.is_some() || name.starts_with("xmlns"))
    {
        let presence = known.map(|known| format!("\n\n{}", presence(known))).unwrap_or_default();
        let values: Vec<String> =
            known.map_or(&[][..], |known| known.values).iter().map(|value| format!("`{value}`")).collect();
        let values = if values.is_empty() { String::new() } else { format!(": {}", values.join(", ")) };
        return Some(xml(&format!("<{element} {name}>")) + &format!("\n{page}{presence}{values}"));
    }
    let of_value = context.builtin(db, project).and_then(|(ty, arm)| value_attribute(db, project, ty, arm, name));
    of_value.or_else(|| {
        let page = file_pages::attribute(context.file, element, name)?;
        Some(xml(&format!("<{element} {name}>")) + &format!("\n{page}"))
    })
}

/// An attribute of a value, named as in files of either dialect.
pub(crate) fn value_attribute(
    db: &dyn Db,
    project: Project,
    ty: BaseType,
    arm: Option<Arm>,
    name: &str,
) -> Option<String> {
    let known = types::attributes(ty, arm).iter().find(|known| known.name == name || known.old_name() == name)?;
    if !known.field.is_empty() {
        return field_page(db, project, ty, arm, known.field);
    }
    let page = match known.value {
        AttributeValue::Link => "The physical input, output or serial line that it is linked to: device, `\\`, name.",
        AttributeValue::Father(BaseType::Tool) => "The tool that the tool is relative to, with its index or key.",
        AttributeValue::Father(_) => "The frame that the position is relative to, with its index or key.",
        _ => "The initial value.",
    };
    Some(fenced(&format!("{} {name}", ty.name())) + &format!("\n{page}"))
}

/// Target or meaning of a value.
fn value_page(db: &dyn Db, project: Project, context: &XmlContext<'_>, name: &str, value: &str) -> Option<String> {
    let element = context.cursor.tag.as_ref()?.name;
    match (context.file, element, name) {
        (FileKind::Project, "Parameters" | "parameters", "version") => Some(version_page(db, project, value)),
        (FileKind::Project, "Library" | "Type", "path") | (FileKind::Project, "alias", "interface") => {
            Some(project_page(db, project, value))
        }
        (FileKind::Project, "Data" | "data", "file") => Some(file_page(db, project, value)),
        (FileKind::Data, _, "link" | "ioLink") => link_page(db, project, value),
        _ => None,
    }
}

/// Description of a version, with the features that it does not have.
fn version_page(db: &dyn Db, project: Project, text: &str) -> String {
    let Some(version) = Version::parse(text) else {
        return format!("{} is not a version. Examples of versions: `s7.11`, `s8.10.2Cs9_BS1991`.", code(text));
    };
    let controllers = if version.language() < 8 { "CS8" } else { "CS9" };
    let mut page = fenced(&format!("VAL 3 {version}")) + &format!("\nfor {controllers} controllers");
    page.push('\n');
    if let Some(configured) = project.config(db).and_then(|config| config.version).filter(|other| *other != version) {
        let _ = write!(page, "\n- The configuration sets {configured}, which takes precedence.");
    }
    if let Some(limit) = version.identifier_limit() {
        let _ = write!(page, "\n- Names have at most {limit} characters.");
    }
    let missing = [
        (version.has_user_types(), "user types (from s7)"),
        (version.has_collections(), "collections and arrays of several dimensions (from s7)"),
        (version.allows_sub_folders(), "programs in folders below the application (from s8.20)"),
    ];
    let missing: Vec<&str> = missing.iter().filter(|(has, _)| !has).map(|(_, what)| *what).collect();
    if !missing.is_empty() {
        let _ = write!(page, "\n- It does not support {}.", missing.join(", "));
    }
    let lacking: Vec<String> = instructions::all()
        .iter()
        .filter(|instruction| instruction.family != Family::AddOns && !instruction.exists_in(version))
        .map(|instruction| format!("`{}`", instruction.name))
        .collect();
    if !lacking.is_empty() {
        let more = if lacking.len() > SHOWN { format!(" and {} more", lacking.len() - SHOWN) } else { String::new() };
        let shown: Vec<&str> = lacking.iter().take(SHOWN).map(String::as_str).collect();
        let _ = write!(page, "\n- Unsupported instructions: {}{more}.", shown.join(", "));
    }
    page
}

/// Project to which a path resolves, with its interface.
fn project_page(db: &dyn Db, project: Project, path: &str) -> String {
    let Some(found) = find_project(db, project, path) else {
        return format!("No project exists at the path {}.", code(path));
    };
    let mut page = format!("{}\n\n{}\n", place_of(db, found), code(found.manifest(db).path(db).as_str()));
    let mut lines = interface(db, found);
    if lines.is_empty() {
        return page + "\nIt has no public data and programs.";
    }
    if lines.len() > SHOWN {
        let more = lines.len() - SHOWN;
        lines.truncate(SHOWN);
        lines.push(format!("// and {more} more"));
    }
    let _ = write!(page, "\ninterface\n{}", fenced(&lines.join("\n")));
    page
}

/// Public data and programs of a project, one line each.
fn interface(db: &dyn Db, project: Project) -> Vec<String> {
    let items = items(db, project);
    let mut data: Vec<String> = items
        .data
        .iter()
        .filter(|(_, item)| item.decl.public)
        .map(|(name, item)| format!("{} {name}{}", item.decl.type_name, shape(&item.decl.sizes, item.decl.container)))
        .collect();
    let programs = items.programs.values().filter(|file| header(db, **file).public);
    let mut programs: Vec<String> = programs.map(|file| program_line(db, project, *file)).collect();
    data.sort_unstable();
    programs.sort_unstable();
    data.into_iter().chain(programs).collect()
}

/// A data file of the project.
fn file_page(db: &dyn Db, project: Project, name: &str) -> String {
    match find_file(db, project, name) {
        Some(file) => {
            let variables = data(db, file).len();
            let noun = if variables == 1 { "variable" } else { "variables" };
            format!("{}\n\n{variables} {noun}", code(file.path(db).as_str()))
        }
        None => format!("{} is no file in the folder of the project.", code(name)),
    }
}

/// Input or output of the cell to which a link refers.
fn link_page(db: &dyn Db, project: Project, link: &str) -> Option<String> {
    let (device, name) = link.split_once('\\')?;
    let channels = project.cell(db)?.config(db).io.devices.get(device)?;
    Some(match channels.get(name) {
        Some(ty) => format!("{} of the device {}, a `{}`", code(name), code(device), ty.name()),
        None => format!("The device {} has no entry {}.", code(device), code(name)),
    })
}
