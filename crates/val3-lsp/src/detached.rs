//! Documents that no project lists: each gets a project of its own, in which names that the document does not declare
//! may exist. So features work, and faults that only a project could show are not reported.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, Sources};
use val3_analysis::paths::path_key;

use crate::documents::Documents;

/// The end of the path of the project file.
const ENDING: &str = ".loose.pjx";

/// The documents of VAL 3 that no project lists, by path. Those in `before` are listed by the project they got.
pub(crate) fn documents(documents: &Documents, db: &Database, before: &[Utf8PathBuf]) -> Vec<Utf8PathBuf> {
    let listed = |path: &Utf8Path| {
        let Some(sources) = Sources::try_get(db) else { return false };
        let Some(file) = sources.files(db).get(&path_key(path.as_str())) else { return false };
        let projects = val3_ide::projects_of(db, *file);
        projects.iter().any(|project| !is_manifest(project.manifest(db).path(db)))
    };
    let ours = |path: &Utf8Path| before.iter().any(|known| known == path) || is_part(path);
    let open = documents.iter().map(|document| document.path.clone());
    let mut detached: Vec<_> = open.filter(|path| ours(path) && !listed(path)).collect();
    detached.sort_unstable();
    detached
}

fn is_part(path: &Utf8Path) -> bool {
    let is = |ending: &str| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(ending));
    is("pgx") || is("dtx")
}

/// The path of the project file that a document gets; there is no such file.
pub(crate) fn manifest_path(document: &Utf8Path) -> Utf8PathBuf {
    format!("{document}{ENDING}").into()
}

/// Whether a path is that of such a project file.
pub(crate) fn is_manifest(path: &Utf8Path) -> bool {
    path.as_str().ends_with(ENDING)
}

/// The project file of a document. It lacks its end, since the document may use names that it would declare.
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
