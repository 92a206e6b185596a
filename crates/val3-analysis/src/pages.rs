//! User pages of s8: HTML files in the folder `interface` of an application, and their bindings to data and programs.

mod binding_file;
mod check;
mod escapes;
mod html;
mod json;
mod page_names;

use smol_str::SmolStr;

use crate::db::{Db, File, Project};

pub use binding_file::{Bindings, BoundData, BoundName, Callback, bindings};
pub use check::problems;
pub use escapes::{escaped, unescaped};
pub use html::{PageIds, page_ids};
pub(crate) use page_names::{element, occurrences};

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
    project.pages(db).iter().copied().filter(|file| is_bindings(db, *file))
}

/// Whether a file has the bindings of a page, by its name.
pub fn is_bindings(db: &dyn Db, file: File) -> bool {
    file.path(db).file_name().is_some_and(|name| page_name(name, BINDINGS).is_some())
}

/// The HTML file of the page called `name`, in any letter case.
pub fn html_file(db: &dyn Db, project: Project, name: &str) -> Option<File> {
    let page = |file: &File| {
        let own = file.path(db).file_name().and_then(|own| page_name(own, HTML));
        own.is_some_and(|own| own.eq_ignore_ascii_case(name))
    };
    project.pages(db).iter().copied().find(page)
}

/// The HTML file of the page to which a file of a project's pages belongs.
pub fn page_of(db: &dyn Db, project: Project, file: File) -> Option<File> {
    let name = file.path(db).file_name()?;
    let page = page_name(name, BINDINGS).or_else(|| page_name(name, HTML))?;
    html_file(db, project, page)
}

/// The names of the pages of a project.
pub fn names(db: &dyn Db, project: Project) -> Vec<SmolStr> {
    let files = project.pages(db).iter().filter_map(|file| file.path(db).file_name());
    files.filter_map(|name| page_name(name, HTML)).map(SmolStr::from).collect()
}
