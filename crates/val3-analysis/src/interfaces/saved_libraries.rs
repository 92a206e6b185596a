//! Libraries that an application writes with `libSave`, and which therefore need not exist before the run (6.7).

use camino::Utf8Path;

use super::{LoadedPath, uses};
use crate::db::{Db, Project};
use crate::items::project::{folder, items, program_files};
use crate::paths::{self, ResolvedPath, path_key};

/// Whether the application or one of its libraries may save a library as the project file `target`. A `libSave` whose
/// path begins with a variable is ignored, because it would otherwise hide every misspelt path of the application.
pub(super) fn is_saved(db: &dyn Db, project: Project, target: &Utf8Path) -> bool {
    let libraries = items(db, project).libraries.values().filter_map(|library| library.interface);
    std::iter::once(project).chain(libraries).any(|project| saves(db, project, target))
}

fn saves(db: &dyn Db, project: Project, target: &Utf8Path) -> bool {
    let paths = program_files(db, project).iter().flat_map(|file| &uses(db, *file).saves);
    let mut paths = paths.filter(|path| **path != LoadedPath::Unknown);
    paths.any(|path| leads_to(db, project, path, target))
}

fn leads_to(db: &dyn Db, project: Project, path: &LoadedPath, target: &Utf8Path) -> bool {
    let (folder, roots) = (folder(db, project), project.roots(db));
    match path {
        LoadedPath::Whole(path) => match paths::project(folder, roots, path) {
            ResolvedPath::Path(saved) => paths::is_same(&saved, target),
            ResolvedPath::Elsewhere => false,
        },
        LoadedPath::Prefix { text, .. } => paths::projects_from(folder, roots, text).is_some_and(|(start, partial)| {
            paths::inside(target, &start).is_some_and(|rest| path_key(rest.as_str()).starts_with(&partial))
        }),
        LoadedPath::Unknown => false,
    }
}
