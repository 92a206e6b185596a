//! Projects to which a file belongs.

use rustc_hash::FxHashMap;
use val3_analysis::db::{Db, File, Project, Sources};
use val3_analysis::occurrences::project_files;

/// Projects by file, sorted by path.
#[salsa::tracked]
fn owners(db: &dyn Db, sources: Sources) -> FxHashMap<File, Vec<Project>> {
    let mut projects: Vec<(&String, &Project)> = sources.projects(db).iter().collect();
    projects.sort_unstable_by_key(|(path, _)| *path);
    let mut owners: FxHashMap<File, Vec<Project>> = FxHashMap::default();
    for (_, project) in projects {
        for file in project_files(db, *project) {
            owners.entry(file).or_default().push(*project);
        }
    }
    owners
}

/// Projects that list the file, or whose project file it is.
pub fn projects_of(db: &dyn Db, file: File) -> &[Project] {
    owners(db, Sources::get(db)).get(&file).map_or(&[], Vec::as_slice)
}

/// Whether the file belongs to a user page. It contains names, but neither VAL 3 code nor VAL 3 elements.
pub(crate) fn is_page(db: &dyn Db, file: File) -> bool {
    projects_of(db, file).iter().any(|project| project.pages(db).contains(&file))
}

/// Applications whose `cell.toml` the file is.
pub(crate) fn surrounded(db: &dyn Db, file: File) -> impl Iterator<Item = Project> {
    projects_of(db, file).iter().copied().filter(move |project| project.surroundings(db) == Some(file))
}

/// Whether the file is the `cell.toml` of an application. It contains names of data, but no XML.
pub(crate) fn is_cell_file(db: &dyn Db, file: File) -> bool {
    surrounded(db, file).next().is_some()
}

/// Project in which a file is displayed: preferably the project in the file's own folder.
pub fn owner(db: &dyn Db, file: File) -> Option<Project> {
    let projects = projects_of(db, file);
    let folder = file.path(db).parent();
    let own = projects.iter().find(|project| project.manifest(db).path(db).parent() == folder);
    own.or(projects.first()).copied()
}
