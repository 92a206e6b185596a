//! Locations of declarations, looked up only for messages.
//!
//! Each function is a separate query, so that a message depends only on the declaration's range, not on the rest of the
//! file.

use smol_str::SmolStr;
use val3_syntax::TextRange;

use super::manifest::{ListNames, OLD, entries, spelling};
use super::{data as data_items, parse, program as program_items};
use crate::db::{Db, File, FileRange, Project};
use crate::xml::{self, XmlElement};

/// Returns the location of a global variable's name in a `.dtx`.
#[salsa::tracked(returns(copy))]
pub fn data(db: &dyn Db, file: File, name: SmolStr) -> Option<FileRange> {
    let parse = parse(db, file);
    let range = named(data_items::elements(parse.view()), "name", &name)?;
    Some(FileRange { file, range })
}

/// A declaration in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Declared {
    /// Declared name.
    pub name: SmolStr,
    /// Range of the name.
    pub range: TextRange,
    /// Range of the element.
    pub element: TextRange,
}

/// Returns all global variables in a `.dtx`, in order.
pub fn all_data(db: &dyn Db, file: File) -> Vec<Declared> {
    let parse = parse(db, file);
    names(data_items::elements(parse.view()))
}

/// Returns all parameters of a `.pgx`, in order.
pub fn all_params(db: &dyn Db, file: File) -> Vec<Declared> {
    let parse = parse(db, file);
    let program = program_items::element(parse.view());
    program.map(|program| names(program_items::params(program))).unwrap_or_default()
}

/// Returns all locals of a `.pgx`, in order.
pub fn all_locals(db: &dyn Db, file: File) -> Vec<Declared> {
    let parse = parse(db, file);
    let program = program_items::element(parse.view());
    program.map(|program| names(program_items::locals(program))).unwrap_or_default()
}

/// Returns the location of a parameter's name in a `.pgx`.
#[salsa::tracked(returns(copy))]
pub fn param(db: &dyn Db, file: File, name: SmolStr) -> Option<FileRange> {
    let parse = parse(db, file);
    let program = program_items::element(parse.view())?;
    Some(FileRange { file, range: named(program_items::params(program), "name", &name)? })
}

/// Returns the location of a local's name in a `.pgx`.
#[salsa::tracked(returns(copy))]
pub fn local(db: &dyn Db, file: File, name: SmolStr) -> Option<FileRange> {
    let parse = parse(db, file);
    let program = program_items::element(parse.view())?;
    Some(FileRange { file, range: named(program_items::locals(program), "name", &name)? })
}

/// Returns the location of the program's name in a `.pgx`.
#[salsa::tracked(returns(copy))]
pub fn program(db: &dyn Db, file: File) -> Option<FileRange> {
    let parse = parse(db, file);
    let program = program_items::element(parse.view())?;
    Some(FileRange { file, range: program.attribute("name")?.range })
}

/// Returns the location of a library identifier in a `.pjx`.
#[salsa::tracked(returns(copy))]
pub fn library(db: &dyn Db, project: Project, alias: SmolStr) -> Option<FileRange> {
    let file = project.manifest(db);
    let parse = parse(db, file);
    let root = xml::root(parse.view())?;
    let spelling = spelling(root);
    let range = named(entries(root, spelling.libraries), spelling.library_name, &alias)?;
    Some(FileRange { file, range })
}

/// Returns the location of a user type's name in a `.pjx`.
#[salsa::tracked(returns(copy))]
pub fn user_type(db: &dyn Db, project: Project, name: SmolStr) -> Option<FileRange> {
    let file = project.manifest(db);
    let parse = parse(db, file);
    let root = xml::root(parse.view())?;
    let range = named(entries(root, spelling(root).types), "name", &name)?;
    Some(FileRange { file, range })
}

/// Returns the range of the version in a `.pjx`.
pub fn version(db: &dyn Db, project: Project) -> Option<TextRange> {
    let parse = parse(db, project.manifest(db));
    let root = xml::root(parse.view())?;
    Some(root.child(&[spelling(root).parameters])?.attribute("version")?.range)
}

/// Returns the range of a program file's entry in a `.pjx`.
pub fn program_file(db: &dyn Db, project: Project, reference: &str) -> Option<TextRange> {
    let parse = parse(db, project.manifest(db));
    let root = xml::root(parse.view())?;
    named(entries(root, spelling(root).programs), "file", reference)
}

/// Returns the range of the innermost element that contains `place`.
pub fn element_around(db: &dyn Db, file: File, place: TextRange) -> Option<TextRange> {
    let parse = parse(db, file);
    let mut found = xml::root(parse.view())?;
    while let Some(inner) = found.elements().find(|inner| inner.view().range().contains_range(place)) {
        found = inner;
    }
    Some(found.view().range()).filter(|range| range.contains_range(place))
}

/// A list of files in a `.pjx`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FileList {
    /// Range of the list's tag, or of the root's tag if the list is missing.
    pub place: TextRange,
    /// Tag of the entries.
    pub item: &'static str,
    /// Range of the last entry.
    pub last: Option<TextRange>,
}

/// Returns the list of program files or data files of a project.
pub fn file_list(db: &dyn Db, project: Project, of_programs: bool) -> Option<FileList> {
    let parse = parse(db, project.manifest(db));
    let root = xml::root(parse.view())?;
    let spelling = spelling(root);
    let names = if of_programs { spelling.programs } else { spelling.data };
    let last = entries(root, names).last().map(|entry| entry.view().range());
    Some(FileList { place: root.child(&[names.list]).unwrap_or(root).name_range(), item: names.item, last })
}

/// Returns the edit that adds a file to the list in the project file: replaced range and new text.
pub fn listing(db: &dyn Db, project: Project, of_programs: bool, name: &str) -> Option<(TextRange, String)> {
    let parse = parse(db, project.manifest(db));
    let root = xml::root(parse.view())?;
    let spelling = spelling(root);
    let ListNames { list, item } = if of_programs { spelling.programs } else { spelling.data };
    let entry = format!("<{item} file=\"{name}\" />");
    let after = |element: XmlElement<'_>| TextRange::empty(element.view().range().end());
    if let Some(last) = root.list(list, item).last() {
        return Some((after(last), entry));
    }
    let whole = format!("<{list}>{entry}</{list}>");
    let place = root.child(&[list]).map(|empty| empty.view().range());
    Some((place.or_else(|| root.elements().last().map(after))?, whole))
}

/// Whether the project file has the format of s5 and s6.
pub fn is_old(db: &dyn Db, project: Project) -> bool {
    let parse = parse(db, project.manifest(db));
    xml::root(parse.view()).is_some_and(|root| root.name() == OLD.root)
}

fn names<'g>(elements: impl Iterator<Item = XmlElement<'g>>) -> Vec<Declared> {
    elements.filter_map(declared).collect()
}

fn declared(element: XmlElement<'_>) -> Option<Declared> {
    let name = element.attribute("name")?;
    Some(Declared { name: name.text().into(), range: name.range, element: element.view().range() })
}

fn named<'g>(mut elements: impl Iterator<Item = XmlElement<'g>>, attribute: &str, name: &str) -> Option<TextRange> {
    elements
        .find_map(|element| element.attribute(attribute).filter(|found| found.text() == name).map(|found| found.range))
}
