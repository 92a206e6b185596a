//! User pages of s8: HTML files in the folder `interface` of an application, and their bindings to data and programs.

mod binding_file;
mod check;
mod json;

use smol_str::SmolStr;
use val3_syntax::{TextRange, TextSize};

use crate::db::{Db, File, Project};
use crate::items::project::items;
use crate::occurrences::{Occurrence, Symbol, Usage};

pub use binding_file::{Bindings, BoundName, bindings};
pub use check::problems;

/// The folder of the user pages of an application.
pub const FOLDER: &str = "interface";

/// The ending of the file with the bindings of a page.
pub const BINDINGS: &str = ".bindings.json";

/// The ending of the file of a page.
pub const HTML: &str = ".html";

/// The name of the page that a file belongs to, by the ending of the file.
pub fn page_name<'p>(file: &'p str, ending: &str) -> Option<&'p str> {
    let at = file.len().checked_sub(ending.len())?;
    let (name, end) = (file.get(..at)?, file.get(at..)?);
    (!name.is_empty() && end.eq_ignore_ascii_case(ending)).then_some(name)
}

/// The files with the bindings of a project's pages.
pub fn binding_files(db: &dyn Db, project: Project) -> impl Iterator<Item = File> {
    let is_bindings = |file: &File| file.path(db).file_name().is_some_and(|name| page_name(name, BINDINGS).is_some());
    project.pages(db).iter().copied().filter(is_bindings)
}

/// The names of data and programs in a file with bindings.
pub(crate) fn occurrences(db: &dyn Db, project: Project, file: File) -> Vec<Occurrence> {
    let (found, known) = (bindings(db, file), items(db, project));
    let data = found.data.iter().filter_map(|bound| {
        let name = bound.root();
        let symbol = known.data.contains_key(name).then(|| Symbol::Data(project, name.into()))?;
        Some(occurrence(bound, name, symbol, if bound.is_written { Usage::Write } else { Usage::Read }))
    });
    let programs = found.programs.iter().filter_map(|bound| {
        let name = bound.text.as_str();
        let symbol = known.programs.contains_key(name).then(|| Symbol::Program(project, name.into()))?;
        Some(occurrence(bound, name, symbol, Usage::Read))
    });
    data.chain(programs).collect()
}

fn occurrence(bound: &BoundName, name: &str, symbol: Symbol, usage: Usage) -> Occurrence {
    Occurrence { range: TextRange::at(bound.range.start(), TextSize::of(name)), symbol, usage }
}

/// The names of the pages of a project.
pub fn names(db: &dyn Db, project: Project) -> Vec<SmolStr> {
    let files = project.pages(db).iter().filter_map(|file| file.path(db).file_name());
    files.filter_map(|name| page_name(name, HTML)).map(SmolStr::from).collect()
}
