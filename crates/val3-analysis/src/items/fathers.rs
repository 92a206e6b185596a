//! Which data hang on which frames and tools, as the values at the start say (9.4 to 9.6).

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_lang::builtins::{self, Builtin};
use val3_lang::types::BaseType;
use val3_syntax::TextRange;

use super::data::elements;
use super::parse;
use super::project::{data_files, items};
use crate::db::{Db, File, FileRange, Project};
use crate::ty::Base;
use crate::xml::Element;

/// The names of the data and of the library identifiers that some data of the project hang on.
#[salsa::tracked]
pub fn fathers(db: &dyn Db, project: Project) -> FxHashSet<SmolStr> {
    data_files(db, project).iter().flat_map(|file| fathers_in(db, *file)).cloned().collect()
}

/// Those that data in a `.dtx` hang on.
#[salsa::tracked]
pub(crate) fn fathers_in(db: &dyn Db, file: File) -> FxHashSet<SmolStr> {
    let parse = parse(db, file);
    let mut names = FxHashSet::default();
    for element in elements(parse.view()) {
        collect(element, &mut names);
    }
    names
}

/// The built-in frame or tool whose name data of another type has taken, while other data hang on it.
pub fn hidden_father(db: &dyn Db, project: Project, name: &str) -> Option<&'static Builtin> {
    let builtin = builtins::find(name).filter(|builtin| builtin.is_variable)?;
    let item = items(db, project).data.get(name)?;
    let is_hidden = !item.base.same_as(Base::of(builtin.ty)) && fathers(db, project).contains(name);
    is_hidden.then_some(builtin)
}

/// Where the data of a project name `name` as a father.
pub fn references(db: &dyn Db, project: Project, name: &str) -> Vec<FileRange> {
    let mut places = Vec::new();
    for &file in data_files(db, project) {
        let parse = parse(db, file);
        let mut ranges = Vec::new();
        elements(parse.view()).for_each(|element| collect_references(element, name, &mut ranges));
        places.extend(ranges.into_iter().map(|range| FileRange { file, range }));
    }
    places
}

fn collect_references(element: Element<'_>, name: &str, ranges: &mut Vec<TextRange>) {
    let old = element.attribute("name").filter(|_| element.name().ends_with("Father"));
    let named = [old, element.attribute(FATHER)].into_iter().flatten();
    ranges.extend(named.filter(|father| root(&father.text()) == name).map(|father| father.range));
    element.elements().for_each(|inner| collect_references(inner, name, ranges));
}

/// Looks at the values, and at those of the fields of user types.
fn collect(element: Element<'_>, names: &mut FxHashSet<SmolStr>) {
    if element.name().ends_with("Father") {
        names.extend(["alias", "name"].iter().filter_map(|name| element.value(name)).map(SmolStr::from));
    }
    names.extend(element.value(FATHER).map(|father| SmolStr::from(root(&father))));
    element.elements().for_each(|inner| collect(inner, names));
}

/// The name before the first index, field or colon.
pub(crate) fn root(reference: &str) -> &str {
    reference.split(['[', '.', ':']).next().unwrap_or(reference).trim()
}

const FATHER: &str = "fatherId";

/// Points, frames and tools of a `.dtx` whose first value that hangs on nothing has this key: name, key and place of
/// the name. The old dialect names one father for all values.
pub fn without_father(db: &dyn Db, file: File) -> Vec<(SmolStr, String, TextRange)> {
    let parse = parse(db, file);
    elements(parse.view()).filter_map(unlinked).collect()
}

fn unlinked(element: Element<'_>) -> Option<(SmolStr, String, TextRange)> {
    let name = element.attribute("name")?;
    let ty = element.value("type")?;
    let is_built_in = |base: BaseType| builtins::find(&name.text()).is_some_and(|builtin| builtin.ty == base);
    BaseType::from_file_name(&ty).filter(|(base, _)| base.has_father() && !is_built_in(*base))?;
    let is_linked = |value: Element<'_>| value.value(FATHER).is_some_and(|father| !father.trim().is_empty());
    let mut values = element.elements().peekable();
    if values.peek().is_none() && element.value("size").is_some() {
        return Some((name.text().into(), "0".to_owned(), name.range));
    }
    let key = values.find(|value| !is_linked(*value))?.value("key")?.into_owned();
    Some((name.text().into(), key, name.range))
}
