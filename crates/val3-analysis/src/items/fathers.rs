//! Father references in data files: the frame or tool to which each initial value is relative (9.4 to 9.6).

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_lang::builtins::{self, Builtin};
use val3_lang::data_path::DataPath;
use val3_lang::types::BaseType;
use val3_syntax::TextRange;

use super::data::elements;
use super::parse;
use super::project::{data_files, items};
use crate::db::{Db, File, FileRange, Project};
use crate::ty::Base;
use crate::xml::XmlElement;

/// Returns the names of all fathers in a project's data, and of the library identifiers before them.
#[salsa::tracked]
pub fn fathers(db: &dyn Db, project: Project) -> FxHashSet<SmolStr> {
    data_files(db, project).iter().flat_map(|file| fathers_in(db, *file)).cloned().collect()
}

/// Returns the names of all fathers in a `.dtx`.
#[salsa::tracked]
pub(crate) fn fathers_in(db: &dyn Db, file: File) -> FxHashSet<SmolStr> {
    let parse = parse(db, file);
    let mut names = FxHashSet::default();
    for element in elements(parse.view()) {
        collect(element, &mut names);
    }
    names
}

/// Returns the built-in frame or tool that is hidden by data with another type, if other data name it as a father.
pub fn hidden_father(db: &dyn Db, project: Project, name: &str) -> Option<&'static Builtin> {
    let builtin = builtins::find(name).filter(|builtin| builtin.is_variable)?;
    let item = items(db, project).data.get(name)?;
    let is_hidden = !item.base.same_as(Base::of(builtin.ty)) && fathers(db, project).contains(name);
    is_hidden.then_some(builtin)
}

/// Returns the locations of all references to the father `name` in a project's data.
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

fn collect_references(element: XmlElement<'_>, name: &str, ranges: &mut Vec<TextRange>) {
    let old = element.attribute("name").filter(|_| element.name().ends_with("Father"));
    let named = [old, element.attribute(FATHER)].into_iter().flatten();
    ranges.extend(named.filter(|father| root(&father.text()) == name).map(|father| father.range));
    element.elements().for_each(|inner| collect_references(inner, name, ranges));
}

/// Collects fathers from the values, and from the values of user type fields.
fn collect(element: XmlElement<'_>, names: &mut FxHashSet<SmolStr>) {
    if element.name().ends_with("Father") {
        names.extend(["alias", "name"].iter().filter_map(|name| element.value(name)).map(SmolStr::from));
    }
    names.extend(element.value(FATHER).map(|father| SmolStr::from(root(&father))));
    element.elements().for_each(|inner| collect(inner, names));
}

/// Returns the first name of a reference: of the library, or of the data.
pub(crate) fn root(reference: &str) -> &str {
    let path = DataPath::new(reference);
    path.library().unwrap_or(path.root()).trim()
}

const FATHER: &str = "fatherId";

/// Returns the points, frames and tools of a `.dtx` with a value without a father: name, key of the first such value,
/// and range of the name. In the old dialect one father applies to all values.
pub fn without_father(db: &dyn Db, file: File) -> Vec<(SmolStr, String, TextRange)> {
    let parse = parse(db, file);
    elements(parse.view()).filter_map(unlinked).collect()
}

fn unlinked(element: XmlElement<'_>) -> Option<(SmolStr, String, TextRange)> {
    let name = element.attribute("name")?;
    let ty = element.value("type")?;
    let (base, _) = BaseType::from_file_name(&ty)?;
    if !base.has_father() || is_built_in(&name.text(), base) {
        return None;
    }
    let mut values = element.elements().peekable();
    if values.peek().is_none() && element.value("size").is_some() {
        return Some((name.text().into(), "0".to_owned(), name.range));
    }
    let key = values.find(|value| !names_father(*value))?.value("key")?.into_owned();
    Some((name.text().into(), key, name.range))
}

/// Whether the data are predefined: `world` or `flange`.
fn is_built_in(name: &str, base: BaseType) -> bool {
    builtins::find(name).is_some_and(|builtin| builtin.ty == base)
}

fn names_father(value: XmlElement<'_>) -> bool {
    value.value(FATHER).is_some_and(|father| !father.trim().is_empty())
}
