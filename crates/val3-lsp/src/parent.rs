//! Project of a document outside the workspace.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::paths::inside;
use val3_analysis::system::{PathKind, System};

use crate::documents::Document;

/// Number of folders above a document that are searched for its project.
const HEIGHT: usize = 3;

/// Project file for a document outside `folders`: in the nearest folder above the document that contains one.
pub(crate) fn project_above(system: &dyn System, document: &Document, folders: &[Utf8PathBuf]) -> Option<Utf8PathBuf> {
    if document.uri.scheme() != "file" || folders.iter().any(|folder| inside(&document.path, folder).is_some()) {
        return None;
    }
    if is_manifest(&document.path) {
        return Some(document.path.clone());
    }
    document.path.ancestors().skip(1).take(HEIGHT).find_map(|folder| {
        let names = system.list(folder).ok()?;
        let paths = names.iter().map(|name| folder.join(name));
        paths.filter(|path| is_manifest(path)).find(|path| system.kind(path) == Some(PathKind::File))
    })
}

fn is_manifest(path: &Utf8Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("pjx"))
}
