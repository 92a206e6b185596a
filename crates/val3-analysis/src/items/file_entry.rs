//! The entry of a file in a project file.

use smol_str::SmolStr;
use val3_syntax::TextRange;

use super::manifest::{entries, spelling};
use super::parse;
use super::project::find_file;
use crate::db::{Db, File, Project};
use crate::xml;

/// The attribute `file` in an entry.
pub(crate) struct FileEntry {
    /// Path as written in the project file.
    pub(crate) path: SmolStr,
    /// Range of the path in the project file.
    pub(crate) range: TextRange,
}

/// Returns the first entry of `project` for a program or data file; `None` if the project does not list the file.
pub(crate) fn file_entry(db: &dyn Db, project: Project, file: File) -> Option<FileEntry> {
    let parse = parse(db, project.manifest(db));
    let root = xml::root(parse.view())?;
    let spelling = spelling(root);
    let attributes = [spelling.programs, spelling.data]
        .into_iter()
        .flat_map(|list| entries(root, list))
        .filter_map(|element| element.attribute("file"));
    let mut listing = attributes.filter(|path| find_file(db, project, &path.text()) == Some(file));
    let found = listing.next()?;
    Some(FileEntry { path: found.text().as_ref().into(), range: found.range })
}
