//! The outline of one file.

use val3_analysis::db::{Db, File};
use val3_analysis::items::manifest::{entries, spelling};
use val3_analysis::items::{data, parse, program};
use val3_analysis::ty::brackets;
use val3_analysis::xml::{self, Attribute, Element};
use val3_syntax::view::View;

use super::{OutlineItem, SymbolKind};

/// What a file declares, in the order of the text.
pub fn outline(db: &dyn Db, file: File) -> Vec<OutlineItem> {
    let view = View::root(parse(db, file).green());
    let Some(root) = xml::root(view) else { return Vec::new() };
    match root.name() {
        "Project" | "project" => project(root),
        "Database" | "dataList" => data::elements(view).filter_map(datum).collect(),
        _ => program::element(view).and_then(program_item).into_iter().collect(),
    }
}

fn item(element: Element<'_>, name: Attribute<'_>, detail: String, kind: SymbolKind) -> OutlineItem {
    OutlineItem {
        name: name.text().into(),
        detail,
        kind,
        range: element.view().range(),
        name_range: name.range,
        children: Vec::new(),
    }
}

fn project(root: Element<'_>) -> Vec<OutlineItem> {
    let spelling = spelling(root);
    let list = |(list, entry), name: &'static str, detail: &'static str, kind| {
        entries(root, (list, entry)).filter_map(move |element| {
            let detail = element.value(detail).unwrap_or_default().into_owned();
            Some(item(element, element.attribute(name)?, detail, kind))
        })
    };
    let programs = list(spelling.programs, "file", "", SymbolKind::Program);
    let data = list(spelling.data, "file", "", SymbolKind::Data);
    let libraries = list(spelling.libraries, spelling.library_name, spelling.library_path, SymbolKind::Library);
    let types = list(spelling.types, "name", "path", SymbolKind::Type);
    let mut items: Vec<OutlineItem> = programs.chain(data).chain(libraries).chain(types).collect();
    items.sort_by_key(|item| item.range.start());
    items
}

fn datum(element: Element<'_>) -> Option<OutlineItem> {
    let decl = data::declaration(element)?;
    let sizes: Vec<String> = decl.sizes.iter().map(u32::to_string).collect();
    let shape = match decl.sizes.as_slice() {
        [1] => String::new(),
        [] => brackets(decl.container).to_owned(),
        _ => format!("[{}]", sizes.join(",")),
    };
    let access = if decl.public { "public " } else { "" };
    let detail = format!("{access}{}{shape}", decl.type_name);
    Some(item(element, element.attribute("name")?, detail, SymbolKind::Data))
}

fn program_item(element: Element<'_>) -> Option<OutlineItem> {
    let params: Vec<OutlineItem> =
        program::params(element).filter_map(|param| variable(param, SymbolKind::Parameter)).collect();
    let signature: Vec<String> = params.iter().map(|param| format!("{} {}", param.detail, param.name)).collect();
    let mut found =
        item(element, element.attribute("name")?, format!("({})", signature.join(", ")), SymbolKind::Program);
    found.children = params;
    found.children.extend(program::locals(element).filter_map(|local| variable(local, SymbolKind::Local)));
    Some(found)
}

fn variable(element: Element<'_>, kind: SymbolKind) -> Option<OutlineItem> {
    let detail = data::readable_type(element).to_string();
    Some(item(element, element.attribute("name")?, detail, kind))
}
