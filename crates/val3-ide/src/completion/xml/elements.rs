//! Elements at the cursor. Each is inserted completely, with placeholders for its required parts.

use val3_analysis::db::Project;
use val3_analysis::items::declarations::is_old;
use val3_analysis::items::project::{DataItem, fields};
use val3_analysis::ty::Base;
use val3_lang::file_pages;
use val3_lang::files::{self, ElementPage, FileKind};
use val3_lang::types::{Container, attributes};

use super::snippet::Snippet;
use super::{keys, names};
use crate::completion::list::{CompletionKind as Kind, CompletionList};
use crate::declare::old_data;
use crate::xml_context::XmlContext;

/// Elements that may occur several times in a list, by file kind.
const REPEATED: [(FileKind, &[&str]); 3] = [
    (FileKind::Project, &["Program", "Data", "Library", "Type", "program", "data", "alias"]),
    (FileKind::Data, &["Data", "Value", "Field"]),
    (FileKind::Program, &["Parameter", "Local", "param", "local"]),
];

/// Elements allowed at the cursor; `angle` is the bracket if it is missing.
pub(super) fn elements(found: &mut CompletionList<'_>, context: &XmlContext<'_>, angle: &str) {
    for (place, child) in (0..).zip(children(found, context)) {
        match (child.name, context.base(found.db, found.project)) {
            ("Value", base) => value(found, context, angle, base),
            ("Field", Some(Base::User(project))) => user_fields(found, context, angle, project),
            _ => {
                let known = |attribute: &str| names::likely(found, context, child.name, attribute);
                let mut snippet = Snippet::default();
                snippet.push(angle);
                snippet.element(context.file, child, "", &known);
                add(found, context, child.name, child.name, snippet, -place);
            }
        }
    }
    if context.file == FileKind::Data {
        old_elements(found, context, angle);
    }
}

/// Elements that the parent may contain and does not contain yet.
fn children(found: &CompletionList<'_>, context: &XmlContext<'_>) -> Vec<&'static ElementPage> {
    let Some(parent) = context.cursor.parent() else {
        let root = root(context.file, is_old(found.db, found.project));
        return files::find(context.file, root).filter(|_| context.cursor.siblings.is_empty()).into_iter().collect();
    };
    let known = files::find(context.file, parent.name).map_or(&[][..], |known| known.children);
    let free = known.iter().filter(|child| is_repeated(context.file, child) || !context.cursor.has_sibling(child));
    free.filter_map(|child| files::find(context.file, child)).collect()
}

/// Whether the parent may contain several of these elements.
fn is_repeated(file: FileKind, element: &str) -> bool {
    REPEATED.iter().any(|(of, names)| *of == file && names.contains(&element))
}

fn root(file: FileKind, old: bool) -> &'static str {
    match (file, old) {
        (FileKind::Project, false) => "Project",
        (FileKind::Project, true) => "project",
        (FileKind::Data, false) => "Database",
        (FileKind::Data, true) => "dataList",
        (FileKind::Program, false) => "Programs",
        (FileKind::Program, true) => "programList",
    }
}

fn add(
    found: &mut CompletionList<'_>,
    context: &XmlContext<'_>,
    label: &str,
    name: &str,
    snippet: Snippet,
    score: i32,
) {
    let file = context.file;
    // If the tag already has its end or attributes, only its name is replaced.
    let has_attributes = context.cursor.tag.as_ref().is_some_and(|tag| !tag.attributes.is_empty());
    let is_whole = context.cursor.tag.is_some() && (has_attributes || found.is_before(">") || found.is_before("/>"));
    let added = found.add(label, Kind::Element).scored(score);
    added.with(|item| {
        item.documentation = file_pages::element(file, name).map(str::to_owned);
        item.insert = snippet.text;
        item.plain = snippet.plain;
        item.is_snippet = true;
        if is_whole {
            name.clone_into(&mut item.insert);
            name.clone_into(&mut item.plain);
            item.is_snippet = false;
        }
    });
}

/// `<Value>` with the type's attributes, or a user type's fields.
fn value(found: &mut CompletionList<'_>, context: &XmlContext<'_>, angle: &str, base: Option<Base>) {
    let mut snippet = Snippet::default();
    snippet.push(&format!("{angle}Value key=\""));
    snippet.place(&keys::next(found, context));
    snippet.push("\"");
    match base {
        Some(Base::User(project)) => {
            snippet.push(">");
            for (name, item) in sorted_fields(found, project) {
                snippet.push("\n  <");
                field(&mut snippet, &name, &item);
            }
            snippet.push("\n</Value>");
        }
        _ => {
            let ty = context.builtin(found.db, found.project);
            for attribute in ty.map_or(&[][..], |(ty, arm)| attributes(ty, arm)) {
                snippet.push(&format!(" {}=\"", attribute.name));
                snippet.place(&keys::initial(attribute));
                snippet.push("\"");
            }
            snippet.push(" />");
        }
    }
    add(found, context, "Value", "Value", snippet, 0);
}

/// A `<Field>` for each missing field of the user type.
fn user_fields(found: &mut CompletionList<'_>, context: &XmlContext<'_>, angle: &str, project: Project) {
    for (place, (name, item)) in (0..).zip(sorted_fields(found, project)) {
        if context.cursor.has_sibling_with("name", &name) {
            continue;
        }
        let mut snippet = Snippet::default();
        snippet.push(angle);
        field(&mut snippet, &name, &item);
        add(found, context, &format!("Field {name}"), "Field", snippet, -place);
    }
}

fn sorted_fields(found: &CompletionList<'_>, project: Project) -> Vec<(String, DataItem)> {
    let fields = fields(found.db, project).iter();
    let mut fields: Vec<(String, DataItem)> = fields.map(|(name, item)| (name.to_string(), item.clone())).collect();
    fields.sort_unstable_by(|(a, _), (b, _)| a.cmp(b));
    fields
}

/// A field of a user type, as its project declares it.
fn field(snippet: &mut Snippet, name: &str, item: &DataItem) {
    let ty = &item.decl.type_name;
    let shape = match item.decl.container {
        Container::Collection => format!("xsi:type=\"collection\" type=\"{ty}\""),
        _ => {
            let sizes: Vec<String> = item.decl.sizes.iter().map(u32::to_string).collect();
            format!("xsi:type=\"array\" type=\"{ty}\" size=\"{}\"", sizes.join(" "))
        }
    };
    snippet.push(&format!("Field name=\"{name}\" {shape} />"));
}

/// Data elements of s5 and s6: a section for each type, variables named after their type, and values in several parts.
fn old_elements(found: &mut CompletionList<'_>, context: &XmlContext<'_>, angle: &str) {
    let Some(parent) = context.cursor.parent() else { return };
    if parent.name == "dataList" {
        for (place, section) in (0..).zip(old_data::SECTIONS) {
            if !context.cursor.has_sibling(section) {
                let mut snippet = Snippet::default();
                snippet.list(angle, section);
                add(found, context, section, section, snippet, -place);
            }
        }
        return;
    }
    let in_section = parent.name.strip_suffix("Section");
    let Some(ty) = in_section.or_else(|| context.types().next()) else { return };
    let next = keys::next(found, context);
    old_data::with_model(ty, |root, text| {
        let children: Vec<(&str, &str)> = match in_section {
            Some(_) => vec![(root.name(), text)],
            None => old_data::parts(root, parent.name, text),
        };
        for (place, (name, whole)) in (0..).zip(children) {
            let mut snippet = Snippet::default();
            snippet.push(angle);
            snippet.filled(whole.strip_prefix('<').unwrap_or(whole), &next);
            add(found, context, name, name, snippet, -place);
        }
    });
}
