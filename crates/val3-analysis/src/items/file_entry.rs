//! The entry by which a project lists a file.

use smol_str::SmolStr;
use val3_syntax::TextRange;

use super::manifest::{entries, spelling};
use super::parse;
use super::project::find_file;
use crate::db::{Db, File, Project};
use crate::xml;

/// The attribute `file` of an entry.
pub(crate) struct FileEntry {
    /// The path as the project writes it.
    pub(crate) path: SmolStr,
    /// Its place in the project file.
    pub(crate) range: TextRange,
}

/// The first entry of `project` that lists a program or data file; `None` if there is none.
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
