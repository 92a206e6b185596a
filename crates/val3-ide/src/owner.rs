//! Which project a file belongs to.

use rustc_hash::FxHashMap;
use val3_analysis::db::{Db, File, Project, Sources};
use val3_analysis::occurrences::project_files;

/// The projects of each file, in the order of their paths.
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

/// The projects that list a file, or whose project file it is.
pub fn projects_of(db: &dyn Db, file: File) -> &[Project] {
    owners(db, Sources::get(db)).get(&file).map_or(&[], Vec::as_slice)
}

/// Whether a file belongs to a user page: it has names, but neither code nor elements of VAL 3.
pub(crate) fn is_page(db: &dyn Db, file: File) -> bool {
    projects_of(db, file).iter().any(|project| project.pages(db).contains(&file))
}

/// The project as whose part a file is shown: that of its own folder before others.
pub fn owner(db: &dyn Db, file: File) -> Option<Project> {
    let projects = projects_of(db, file);
    let folder = file.path(db).parent();
    let own = projects.iter().find(|project| project.manifest(db).path(db).parent() == folder);
    own.or(projects.first()).copied()
}
