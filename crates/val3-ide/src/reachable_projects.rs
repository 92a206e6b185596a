//! Projects that an application can reference, and their paths in references.

use camino::Utf8Path;
use val3_analysis::db::{Db, Project, Sources};
use val3_analysis::items::declarations::is_old;
use val3_analysis::items::project::{find_project, folder};

/// Another project, and a path that refers to it.
pub(crate) struct Reachable {
    pub(crate) project: Project,
    /// Path as in programs: only the folder, if that is unambiguous.
    pub(crate) short: String,
    /// Path including the project file.
    pub(crate) long: String,
}

impl Reachable {
    /// File name of the project file, without its extension.
    pub(crate) fn name<'db>(&self, db: &'db dyn Db) -> &'db str {
        self.project.manifest(db).path(db).file_stem().unwrap_or("")
    }

    /// Path for the project file of `project`. Files of s5 and s6 contain the folder without the root.
    pub(crate) fn entry(&self, db: &dyn Db, project: Project) -> String {
        let old = || self.short.strip_prefix(DISK).unwrap_or(&self.short);
        if is_old(db, project) { old().to_owned() } else { self.long.clone() }
    }
}

const DISK: &str = "Disk://";

/// All other projects that `project` can reference, sorted by path. Projects in other cells are unreachable.
pub(crate) fn reachable(db: &dyn Db, project: Project) -> Vec<Reachable> {
    let mut projects: Vec<Project> = Sources::get(db).projects(db).values().copied().collect();
    projects.retain(|other| *other != project);
    projects.sort_unstable_by_key(|other| other.manifest(db).path(db));
    projects.into_iter().filter_map(|other| named(db, project, other)).collect()
}

fn named(db: &dyn Db, project: Project, other: Project) -> Option<Reachable> {
    let long = path(db, project, other.manifest(db).path(db))?;
    let leads_to_other = |reference: &str| find_project(db, project, reference) == Some(other);
    let folder = long.rsplit_once('/').map(|(folder, _)| folder).filter(|folder| leads_to_other(folder));
    let short = folder.unwrap_or(&long).to_owned();
    leads_to_other(&long).then_some(Reachable { project: other, short, long })
}

/// Path of a project file, starting with a root; without roots, relative to the project.
fn path(db: &dyn Db, project: Project, manifest: &Utf8Path) -> Option<String> {
    if let Some(disk) = project.disk(db) {
        if let Ok(relative) = manifest.strip_prefix(disk) {
            return Some(format!("{DISK}{relative}"));
        }
        let others = &project.roots(db).others;
        return others.iter().find_map(|(root, folder)| {
            manifest.strip_prefix(folder).ok().map(|relative| format!("{root}://{relative}"))
        });
    }
    let own = folder(db, project);
    let below = manifest.strip_prefix(own).map(|relative| format!("./{relative}"));
    let beside = || manifest.strip_prefix(own.parent()?).ok().map(|relative| format!("../{relative}"));
    below.ok().or_else(beside)
}
