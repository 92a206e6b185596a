//! Projects of the workspace and their contents, for a tree view.

mod kinds;

pub use kinds::{ProjectKind, project_kinds};

use smol_str::SmolStr;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::interfaces::replacements;
use val3_analysis::items::data::{self, DataDecl};
use val3_analysis::items::manifest::{entries, spelling};
use val3_analysis::items::project::{data_files, find_project, program_files};
use val3_analysis::items::{parse, program};
use val3_analysis::xml::{self, Attribute, XmlElement};
use val3_lang::types::{BaseType, Container, DefaultValue, attributes};
use val3_syntax::TextRange;

use crate::code_lens::runs_alone;
use crate::symbols::{OutlineItem, datum_detail, outline};

/// Contents of a project.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProjectContent {
    /// File name of the `.pjx`, without the extension.
    pub name: SmolStr,
    /// Whether the project's dialect has user types.
    pub has_types: bool,
    /// Programs, in the order of the `.pjx`.
    pub programs: Vec<TreeItem<TreeProgram>>,
    /// Global data, in the order of the files.
    pub data: Vec<TreeItem<TreeData>>,
    /// Library identifiers, in the order of the `.pjx`.
    pub libraries: Vec<TreeItem<TreeReference>>,
    /// User types, in the order of the `.pjx`.
    pub types: Vec<TreeItem<TreeReference>>,
}

/// An item of a project.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TreeItem<T> {
    /// Name.
    pub name: SmolStr,
    /// Type, signature or path in short form; may be empty.
    pub detail: String,
    /// File with the declaration.
    pub file: File,
    /// Range of the entire declaration.
    pub range: TextRange,
    /// Range of the name.
    pub name_range: TextRange,
    /// Details for its kind.
    pub what: T,
}

/// A program of the tree.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TreeProgram {
    /// Whether other projects may call it.
    pub public: bool,
    /// Whether it can be started without a caller: it is `start`, or has no parameters.
    pub runs: bool,
}

/// Global data of the tree.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TreeData {
    /// Type, container, sizes and access.
    pub decl: DataDecl,
    /// Initial value of a single `num`, `bool` or `string`, without quotes.
    pub value: Option<String>,
}

/// A library identifier or a user type of the tree.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TreeReference {
    /// Project at its path; `None` if unresolved.
    pub project: Option<Project>,
    /// Libraries that programs load under this identifier, sorted by path.
    pub loaded: Vec<Project>,
}

/// Contents of `project`, including items whose name is declared twice.
pub fn project_content(db: &dyn Db, project: Project) -> ProjectContent {
    let manifest = project.manifest(db);
    let parse = parse(db, manifest);
    let root = xml::root(parse.view());
    let mut content = ProjectContent {
        name: manifest.path(db).file_stem().unwrap_or("").into(),
        has_types: root.is_some_and(has_types),
        programs: program_files(db, project).iter().flat_map(|file| programs(db, *file)).cloned().collect(),
        data: data_files(db, project).iter().flat_map(|file| data_items(db, *file)).cloned().collect(),
        libraries: Vec::new(),
        types: Vec::new(),
    };
    if let Some(root) = root {
        let spelling = spelling(root);
        let (name, path) = (spelling.library_name, spelling.library_path);
        let libraries = entries(root, spelling.libraries);
        content.libraries = libraries.filter_map(|entry| reference(db, project, entry, name, path)).collect();
        let types = entries(root, spelling.types);
        content.types = types.filter_map(|entry| reference(db, project, entry, "name", "path")).collect();
    }
    content
}

/// Whether a project file of this dialect has user types.
pub(crate) fn has_types(root: XmlElement<'_>) -> bool {
    root.name() == "Project"
}

/// Programs of a file. Memoised per file, so that an edit in one file does not read other files again.
#[salsa::tracked]
fn programs(db: &dyn Db, file: File) -> Vec<TreeItem<TreeProgram>> {
    let header = program::header(db, file);
    let items = outline(db, file).into_iter().map(|OutlineItem { name, detail, range, name_range, .. }| {
        let what = TreeProgram { public: header.public, runs: runs_alone(header) };
        TreeItem { name, detail, file, range, name_range, what }
    });
    items.collect()
}

/// Data of a file, memoised like [`programs`].
#[salsa::tracked]
fn data_items(db: &dyn Db, file: File) -> Vec<TreeItem<TreeData>> {
    let parse = parse(db, file);
    data::elements(parse.view()).filter_map(|element| datum(file, element)).collect()
}

fn datum(file: File, element: XmlElement<'_>) -> Option<TreeItem<TreeData>> {
    let decl = data::declaration(element)?;
    let value = value(element, &decl);
    let detail = datum_detail(&decl);
    Some(item(file, element, element.attribute("name")?, detail, TreeData { decl, value }))
}

/// Initial value of data with a single `num`, `bool` or `string`.
fn value(element: XmlElement<'_>, decl: &DataDecl) -> Option<String> {
    let (ty, _) = BaseType::from_file_name(&decl.type_name)?;
    let is_single = decl.container != Container::Collection && decl.sizes == [1];
    let default = match attributes(ty, None).first().filter(|_| is_single)?.default {
        DefaultValue::False => "false".to_owned(),
        DefaultValue::Number(number) if ty == BaseType::Num => number.to_string(),
        DefaultValue::EmptyText => String::new(),
        _ => return None,
    };
    let written = element.elements().next().and_then(|value| value.value("value"));
    Some(written.map_or(default, |text| text.into_owned()))
}

fn reference(
    db: &dyn Db,
    project: Project,
    entry: XmlElement<'_>,
    name: &str,
    path: &str,
) -> Option<TreeItem<TreeReference>> {
    let name = entry.attribute(name)?;
    let path = entry.value(path).unwrap_or_default().into_owned();
    let target = find_project(db, project, &path);
    let in_its_place = replacements(db, project).iter().filter(|(interface, _)| Some(*interface) == target);
    let loaded = in_its_place.map(|(_, library)| *library).collect();
    Some(item(project.manifest(db), entry, name, path, TreeReference { project: target, loaded }))
}

fn item<T>(file: File, element: XmlElement<'_>, name: Attribute<'_>, detail: String, what: T) -> TreeItem<T> {
    TreeItem { name: name.text().into(), detail, file, range: element.view().range(), name_range: name.range, what }
}

#[cfg(test)]
mod tests;
