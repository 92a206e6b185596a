//! Content of a project file (`.pjx`).

use smol_str::SmolStr;
use val3_lang::types::LengthUnit;
use val3_syntax::view::View;

use super::{is_sound, parse};
use crate::db::{Db, File};
use crate::xml::{self, XmlElement};

/// A project file of either dialect.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Manifest {
    /// Version as written; empty if missing.
    pub version: SmolStr,
    /// Program files as written, in order.
    pub programs: Vec<SmolStr>,
    /// Data files as written, in order.
    pub data: Vec<SmolStr>,
    /// Library identifiers, in order.
    pub libraries: Vec<LibraryEntry>,
    /// User types, in order.
    pub types: Vec<TypeEntry>,
    /// Whether every entry is readable.
    pub complete: bool,
}

impl Manifest {
    /// Returns the paths of the libraries and types, as written.
    pub fn projects(&self) -> Vec<&str> {
        let libraries = self.libraries.iter().map(|entry| entry.path.as_str());
        libraries.chain(self.types.iter().map(|entry| entry.path.as_str())).collect()
    }
}

/// `<Library alias path autoload>`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LibraryEntry {
    /// Library identifier.
    pub alias: SmolStr,
    /// Path as written.
    pub path: SmolStr,
    /// Whether the library is loaded with the application.
    pub autoload: bool,
}

/// `<Type name path>`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TypeEntry {
    /// Type name in this project.
    pub name: SmolStr,
    /// Path as written.
    pub path: SmolStr,
}

/// Names of a list in a project file.
#[derive(Clone, Copy)]
pub struct ListNames {
    /// Element of the list.
    pub list: &'static str,
    /// Element of an entry.
    pub item: &'static str,
}

/// Element and attribute names that differ between the dialects.
pub struct Spelling {
    /// Root element.
    pub root: &'static str,
    /// Element with the version.
    pub parameters: &'static str,
    /// List of program files.
    pub programs: ListNames,
    /// List of data files.
    pub data: ListNames,
    /// List of libraries.
    pub libraries: ListNames,
    /// Attribute for a library's identifier.
    pub library_name: &'static str,
    /// Attribute for a library's path.
    pub library_path: &'static str,
    /// List of user types.
    pub types: ListNames,
}

/// s7 and s8.
pub(crate) const NEW: Spelling = Spelling {
    root: "Project",
    parameters: "Parameters",
    programs: ListNames { list: "Programs", item: "Program" },
    data: ListNames { list: "Database", item: "Data" },
    libraries: ListNames { list: "Libraries", item: "Library" },
    library_name: "alias",
    library_path: "path",
    types: ListNames { list: "Types", item: "Type" },
};

/// s5 and s6; they have no user types.
pub(crate) const OLD: Spelling = Spelling {
    root: "project",
    parameters: "parameters",
    programs: ListNames { list: "programSection", item: "program" },
    data: ListNames { list: "dataSection", item: "data" },
    libraries: ListNames { list: "aliasSection", item: "alias" },
    library_name: "name",
    library_path: "interface",
    types: ListNames { list: "typeSection", item: "type" },
};

/// Returns the dialect of a project file.
pub fn spelling(root: XmlElement<'_>) -> &'static Spelling {
    if root.name() == OLD.root { &OLD } else { &NEW }
}

/// Returns a project parameter (2.1.4) as written in the file.
pub fn parameter(db: &dyn Db, file: File, name: &str) -> Option<String> {
    let parse = parse(db, file);
    let root = xml::root(parse.view())?;
    root.child(&[spelling(root).parameters])?.value(name).map(|text| text.into_owned())
}

/// Returns the length unit of a project (2.1.4.1).
#[salsa::tracked(returns(copy))]
pub fn length_unit(db: &dyn Db, file: File) -> LengthUnit {
    match parameter(db, file, "millimeterUnit").as_deref().map(str::trim) {
        Some("false") => LengthUnit::Inch,
        _ => LengthUnit::Millimetre,
    }
}

/// Reads a `.pjx`.
#[salsa::tracked]
pub fn manifest(db: &dyn Db, file: File) -> Manifest {
    let mut manifest = read(parse(db, file).view());
    manifest.complete &= is_sound(db, file);
    manifest
}

/// Reads the tree of a `.pjx`.
pub fn read(file: View<'_>) -> Manifest {
    let Some(root) = xml::root(file) else { return Manifest::default() };
    let spelling = spelling(root);
    Manifest {
        version: root.child(&[spelling.parameters]).map(|element| value(element, "version")).unwrap_or_default(),
        programs: entries(root, spelling.programs).map(|element| value(element, "file")).collect(),
        data: entries(root, spelling.data).map(|element| value(element, "file")).collect(),
        libraries: entries(root, spelling.libraries).map(|element| library(element, spelling)).collect(),
        types: entries(root, spelling.types)
            .map(|element| TypeEntry { name: value(element, "name"), path: value(element, "path") })
            .collect(),
        complete: is_complete(root, spelling),
    }
}

/// Whether every element is known and has its name attribute.
fn is_complete(root: XmlElement<'_>, spelling: &Spelling) -> bool {
    let lists = [
        (spelling.programs, "file"),
        (spelling.data, "file"),
        (spelling.libraries, spelling.library_name),
        (spelling.types, "name"),
    ];
    root.name() == spelling.root
        && root.elements().filter(|list| list.name() != spelling.parameters).all(|list| {
            let known = lists.iter().find(|(names, _)| names.list == list.name());
            known.is_some_and(|(names, attribute)| {
                list.elements().all(|entry| entry.name() == names.item && entry.value(attribute).is_some())
            })
        })
}

/// Returns the elements of a list in a project file.
pub fn entries<'g>(root: XmlElement<'g>, names: ListNames) -> impl Iterator<Item = XmlElement<'g>> {
    root.list(names.list, names.item)
}

fn library(element: XmlElement<'_>, spelling: &Spelling) -> LibraryEntry {
    LibraryEntry {
        alias: value(element, spelling.library_name),
        path: value(element, spelling.library_path),
        autoload: element.value("autoload").is_none_or(|text| text.trim() != "false"),
    }
}

fn value(element: XmlElement<'_>, attribute: &str) -> SmolStr {
    element.value(attribute).map(SmolStr::from).unwrap_or_default()
}
