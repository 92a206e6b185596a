//! User pages of s8: HTML files in an application's folder `interface`, with bindings to data and programs.

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

/// Folder of the user pages in applications.
pub const FOLDER: &str = "interface";

/// File name suffix of page bindings.
pub const BINDINGS: &str = ".bindings.json";

/// File name suffix of pages.
pub const HTML: &str = ".html";

/// Returns the page name of a file with this suffix.
pub fn page_name<'p>(file: &'p str, ending: &str) -> Option<&'p str> {
    let at = file.len().checked_sub(ending.len())?;
    let (name, end) = (file.get(..at)?, file.get(at..)?);
    (!name.is_empty() && end.eq_ignore_ascii_case(ending)).then_some(name)
}

/// Returns the binding files of a project's pages.
pub fn binding_files(db: &dyn Db, project: Project) -> impl Iterator<Item = File> {
    project.pages(db).iter().copied().filter(|file| is_bindings(db, *file))
}

/// Whether the file name ends like a binding file's.
pub fn is_bindings(db: &dyn Db, file: File) -> bool {
    file.path(db).file_name().is_some_and(|name| page_name(name, BINDINGS).is_some())
}

/// Returns the HTML file of the page called `name`, in any letter case.
pub fn html_file(db: &dyn Db, project: Project, name: &str) -> Option<File> {
    let mut files = project.pages(db).iter().copied();
    files.find(|file| {
        let own = file.path(db).file_name().and_then(|own| page_name(own, HTML));
        own.is_some_and(|own| own.eq_ignore_ascii_case(name))
    })
}

/// Returns the HTML file of the page to which a page file belongs.
pub fn page_of(db: &dyn Db, project: Project, file: File) -> Option<File> {
    let name = file.path(db).file_name()?;
    let page = page_name(name, BINDINGS).or_else(|| page_name(name, HTML))?;
    html_file(db, project, page)
}

/// Returns the names of a project's pages.
pub fn names(db: &dyn Db, project: Project) -> Vec<SmolStr> {
    let files = project.pages(db).iter().filter_map(|file| file.path(db).file_name());
    files.filter_map(|name| page_name(name, HTML)).map(SmolStr::from).collect()
}
