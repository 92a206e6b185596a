//! Unlisted files: programs and data files in a project's folder that the project file does not list.

use camino::Utf8Path;
use rustc_hash::FxHashSet;
use smol_str::SmolStr;

use super::manifest::{Manifest, manifest};
use crate::db::{Db, Project, Sources};
use crate::items::project::folder;
use crate::paths::path_key;

/// Sorted names of files that certainly belong to no project.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Unlisted {
    /// Program files.
    pub programs: Vec<SmolStr>,
    /// Data files.
    pub data: Vec<SmolStr>,
}

/// Returns the unlisted program and data files next to a project's `.pjx`. Returns none if a second project shares the
/// folder or the `.pjx` is partly unreadable.
#[salsa::tracked]
pub fn unlisted(db: &dyn Db, project: Project) -> Unlisted {
    let several = project.beside(db).iter().filter(|name| has_extension(name, "pjx")).count() > 1;
    if several || !manifest(db, project.manifest(db)).complete {
        return Unlisted::default();
    }
    let (programs, data) = unlisted_names(db, project).into_iter().cloned().partition(|name| is_program(name));
    Unlisted { programs, data }
}

/// Returns the files that no project of a shared folder lists. They are returned only for the first of these projects
/// by name, so that each file is reported once. Returns none if any of the projects is not loaded or is partly
/// unreadable.
pub fn unlisted_in_shared_folder(db: &dyn Db, project: Project) -> Unlisted {
    let folder = folder(db, project);
    let names = project.beside(db).iter().filter(|name| has_extension(name, "pjx"));
    let projects = names.map(|name| readable_project(db, &folder.join(name.as_str())));
    let Some(projects) = projects.collect::<Option<Vec<Project>>>() else { return Unlisted::default() };
    if projects.len() < 2 || projects.first() != Some(&project) {
        return Unlisted::default();
    }
    let mut names: Vec<SmolStr> = unlisted_names(db, project).into_iter().cloned().collect();
    for other in &projects {
        let unlisted: FxHashSet<&SmolStr> = unlisted_names(db, *other).into_iter().collect();
        names.retain(|name| unlisted.contains(name));
    }
    let (programs, data) = names.into_iter().partition(|name| is_program(name));
    Unlisted { programs, data }
}

/// Returns the loaded project with this project file, if the file is completely readable.
fn readable_project(db: &dyn Db, path: &Utf8Path) -> Option<Project> {
    let project = Sources::get(db).projects(db).get(&path_key(path.as_str())).copied();
    project.filter(|project| manifest(db, project.manifest(db)).complete)
}

impl Unlisted {
    /// Whether a program file has the name of the program `name`.
    pub fn has_program(&self, name: &str) -> bool {
        let stem = |file: &SmolStr| file.rsplit_once('.').is_some_and(|(stem, _)| stem.eq_ignore_ascii_case(name));
        self.programs.iter().any(stem)
    }

    /// Returns all files.
    pub fn all(&self) -> Vec<SmolStr> {
        self.programs.iter().chain(&self.data).cloned().collect()
    }
}

/// Returns the sorted names of all files in a project's folder that the project does not list. Another project in the
/// folder may list them.
pub fn unlisted_names(db: &dyn Db, project: Project) -> Vec<&SmolStr> {
    let Manifest { programs, data, .. } = manifest(db, project.manifest(db));
    let listed = programs.iter().chain(data).map(|entry| file_name(entry).to_lowercase());
    let listed: FxHashSet<String> = listed.collect();
    let names = project.beside(db).iter().filter(|name| is_program(name) || is_data(name));
    names.filter(|name| !listed.contains(&name.to_lowercase())).collect()
}

/// Whether the file name is a program's.
pub fn is_program(name: &str) -> bool {
    has_extension(name, "pgx")
}

/// Whether the file name is a data file's.
pub fn is_data(name: &str) -> bool {
    has_extension(name, "dtx")
}

fn has_extension(name: &str, wanted: &str) -> bool {
    name.rsplit_once('.').is_some_and(|(_, extension)| extension.eq_ignore_ascii_case(wanted))
}

/// Returns the name of a listed file, without the folder that s8 allows before it.
fn file_name(entry: &str) -> &str {
    entry.trim().rsplit(['/', '\\']).next().unwrap_or(entry)
}
