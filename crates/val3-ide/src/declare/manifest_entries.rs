//! Insertion of elements into a project file.

use val3_analysis::db::{Db, Project};
use val3_analysis::items::manifest::{ListNames, Spelling, spelling};
use val3_analysis::items::parse;
use val3_analysis::xml;

use crate::edit::FileEdit;
use crate::xml_list::{XmlList, escaped};

/// Adds elements for program files to a `.pjx`.
pub(crate) fn program_entries(db: &dyn Db, project: Project, references: &[String]) -> Option<FileEdit> {
    entries(db, project, |spelling| spelling.programs, |_| files(references))
}

/// Adds elements for data files to a `.pjx`.
pub(crate) fn data_entries(db: &dyn Db, project: Project, references: &[String]) -> Option<FileEdit> {
    entries(db, project, |spelling| spelling.data, |_| files(references))
}

fn files(references: &[String]) -> Vec<String> {
    references.iter().map(|reference| format!("file=\"{}\"", escaped(reference))).collect()
}

/// Adds a library identifier with the path of its interface to a `.pjx`.
pub(crate) fn library(db: &dyn Db, project: Project, alias: &str, path: &str) -> Option<FileEdit> {
    entries(db, project, |spelling| spelling.libraries, |spelling| vec![library_attributes(spelling, alias, path)])
}

fn library_attributes(spelling: &Spelling, alias: &str, path: &str) -> String {
    let Spelling { library_name, library_path, .. } = spelling;
    format!("{library_name}=\"{}\" {library_path}=\"{}\"", escaped(alias), escaped(path))
}

/// Adds a user type to a `.pjx` of s7 or s8.
pub(crate) fn user_type(db: &dyn Db, project: Project, name: &str, path: &str) -> Option<FileEdit> {
    user_types(db, project, &[(name.to_owned(), path.to_owned())])
}

/// Adds user types, each given by name and path.
pub(crate) fn user_types(db: &dyn Db, project: Project, types: &[(String, String)]) -> Option<FileEdit> {
    let entry = |(name, path): &(String, String)| format!("name=\"{}\" path=\"{}\"", escaped(name), escaped(path));
    entries(db, project, |spelling| spelling.types, |_: &Spelling| types.iter().map(entry).collect())
}

/// Adds elements with these attributes to a list of the project file.
fn entries(
    db: &dyn Db,
    project: Project,
    list: fn(&Spelling) -> ListNames,
    attributes: impl FnOnce(&Spelling) -> Vec<String>,
) -> Option<FileEdit> {
    let file = project.manifest(db);
    let parse = parse(db, file);
    let parent = xml::root(parse.view())?;
    let spelling = spelling(parent);
    let ListNames { list: name, item } = list(spelling);
    // Elements that follow the list in a project file.
    let order = [spelling.programs, spelling.data, spelling.libraries, spelling.types].map(|names| names.list);
    let followers: Vec<&str> = order.into_iter().skip_while(|other| *other != name).skip(1).collect();
    let list = XmlList { text: file.text(db), parent, name, attributes: "", followers: &followers };
    let entries: Vec<String> = attributes(spelling).iter().map(|entry| format!("<{item} {entry} />")).collect();
    let (range, text) = list.append(&entries)?;
    Some(FileEdit { file, range, text })
}
