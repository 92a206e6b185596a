//! Where things are declared: looked up only when a message points there.
//!
//! Each is a query of its own, so that a message about a declaration depends on its place alone, not on the rest of
//! its file.

use smol_str::SmolStr;
use val3_syntax::TextRange;
use val3_syntax::view::View;

use super::manifest::{entries, spelling};
use super::{data as data_items, parse, program as program_items};
use crate::db::{Db, File, Project};
use crate::problem::Place;
use crate::xml::{self, Element};

/// The name of a global variable in a `.dtx`.
#[salsa::tracked(returns(copy))]
pub fn data(db: &dyn Db, file: File, name: SmolStr) -> Option<Place> {
    let parse = parse(db, file);
    let range = named(data_items::elements(View::root(parse.green())), "name", &name)?;
    Some(Place { file, range })
}

/// The name of a parameter in a `.pgx`.
#[salsa::tracked(returns(copy))]
pub fn param(db: &dyn Db, file: File, name: SmolStr) -> Option<Place> {
    let parse = parse(db, file);
    let program = program_items::element(View::root(parse.green()))?;
    Some(Place { file, range: named(program_items::params(program), "name", &name)? })
}

/// The name of a local in a `.pgx`.
#[salsa::tracked(returns(copy))]
pub fn local(db: &dyn Db, file: File, name: SmolStr) -> Option<Place> {
    let parse = parse(db, file);
    let program = program_items::element(View::root(parse.green()))?;
    Some(Place { file, range: named(program_items::locals(program), "name", &name)? })
}

/// The name of the program in a `.pgx`.
#[salsa::tracked(returns(copy))]
pub fn program(db: &dyn Db, file: File) -> Option<Place> {
    let parse = parse(db, file);
    let program = program_items::element(View::root(parse.green()))?;
    Some(Place { file, range: program.attribute("name")?.range })
}

/// The entry of a library identifier in a `.pjx`.
#[salsa::tracked(returns(copy))]
pub fn library(db: &dyn Db, project: Project, alias: SmolStr) -> Option<Place> {
    let file = project.manifest(db);
    let parse = parse(db, file);
    let root = xml::root(View::root(parse.green()))?;
    let spelling = spelling(root);
    let mut elements = entries(root, spelling.libraries);
    let range = elements.find_map(|element| {
        let found = element.attribute(spelling.library_name)?;
        (found.text() == alias.as_str()).then_some(found.range)
    })?;
    Some(Place { file, range })
}

/// The entry of a user type in a `.pjx`.
#[salsa::tracked(returns(copy))]
pub fn type_entry(db: &dyn Db, project: Project, name: SmolStr) -> Option<Place> {
    let file = project.manifest(db);
    let parse = parse(db, file);
    let root = xml::root(View::root(parse.green()))?;
    let elements = entries(root, spelling(root).types);
    Some(Place { file, range: named(elements, "name", &name)? })
}

fn named<'g>(mut elements: impl Iterator<Item = Element<'g>>, attribute: &str, name: &str) -> Option<TextRange> {
    elements
        .find_map(|element| element.attribute(attribute).filter(|found| found.text() == name).map(|found| found.range))
}
