//! Documents that no project lists. Each belongs to its own generated project, in which undeclared names may exist.
//! Features therefore work, and faults that depend on the project are not reported.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, Sources};
use val3_analysis::paths::path_key;

use crate::documents::Documents;

/// Suffix of the project file's path.
const ENDING: &str = ".loose.pjx";

/// Open VAL 3 documents that no project lists, by path. Documents in `before` count as unlisted although their own
/// detached project lists them.
pub(crate) fn documents(documents: &Documents, db: &Database, before: &[Utf8PathBuf]) -> Vec<Utf8PathBuf> {
    let ours = |path: &Utf8Path| before.iter().any(|known| known == path) || is_part(path);
    let open = documents.iter().map(|document| document.path.clone());
    let mut detached: Vec<_> = open.filter(|path| ours(path) && !is_listed(db, path)).collect();
    detached.sort_unstable();
    detached
}

/// Whether a project lists the file, other than its own detached project.
fn is_listed(db: &Database, path: &Utf8Path) -> bool {
    let Some(sources) = Sources::try_get(db) else { return false };
    let Some(file) = sources.files(db).get(&path_key(path.as_str())) else { return false };
    let projects = val3_ide::projects_of(db, *file);
    projects.iter().any(|project| !is_manifest(project.manifest(db).path(db)))
}

fn is_part(path: &Utf8Path) -> bool {
    let is = |ending: &str| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(ending));
    is("pgx") || is("dtx")
}

/// Path of the project file for a document. No such file exists on the disk.
pub(crate) fn manifest_path(document: &Utf8Path) -> Utf8PathBuf {
    format!("{document}{ENDING}").into()
}

/// Whether a path names the project file of a detached document.
pub(crate) fn is_manifest(path: &Utf8Path) -> bool {
    path.as_str().ends_with(ENDING)
}

/// Project file text for a document. Its end is missing, because the document may use names that a complete project
/// would declare there.
pub(crate) fn manifest(document: &Utf8Path) -> String {
    let name = document.file_name().unwrap_or("").replace('&', "&amp;").replace('"', "&quot;").replace('<', "&lt;");
    let is_data = document.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("dtx"));
    let entry = match is_data {
        true => format!("<Database><Data file=\"{name}\" /></Database>"),
        false => format!("<Programs><Program file=\"{name}\" /></Programs>"),
    };
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\">\n{entry}"
    )
}
