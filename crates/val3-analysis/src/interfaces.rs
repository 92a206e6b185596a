//! Checks libraries against the interfaces under which they are loaded (6.2, 6.3, 6.6).
//!
//! An identifier names an interface. Any library may be loaded under it if the library has all used items of the
//! interface, as public items of the same kind.

mod compare;
mod incomplete_libraries;
mod saved_libraries;
mod usage;

use rustc_hash::FxHashSet;
use smol_str::SmolStr;

use crate::db::{Db, File, FileRange, Project, Sources};
use crate::items::declarations;
use crate::items::program::header;
use crate::items::project::{find_project, folder, items, program_files};
use crate::paths::{self, ResolvedPath, path_key};

use crate::problem::{FileRole, Problem, ProblemKind};

pub use compare::{implements, is_same_item};
pub(crate) use incomplete_libraries::is_left_out;
pub use usage::{LibraryUses, Load, LoadedPath, uses};

/// Returns the interface problems of a project's libraries.
#[salsa::tracked]
pub fn problems(db: &dyn Db, project: Project) -> Vec<Problem> {
    let items = items(db, project);
    if items.libraries.is_empty() {
        return Vec::new();
    }
    let mut check = Interfaces::of(db, project);
    let mut aliases: Vec<&SmolStr> = items.libraries.keys().collect();
    aliases.sort_unstable();
    for alias in aliases {
        check.never_loaded(alias);
        check.loads(alias);
    }
    check.left_out();
    check.problems
}

/// Returns pairs: an interface project, and a library that a program loads in its place.
#[salsa::tracked]
pub fn replacements(db: &dyn Db, project: Project) -> Vec<(Project, Project)> {
    if items(db, project).libraries.is_empty() {
        return Vec::new();
    }
    let mut check = Interfaces::of(db, project);
    let mut found = Vec::new();
    for (alias, library) in &items(db, project).libraries {
        let Some(interface) = library.interface else { continue };
        let loaded = check.loaded(alias);
        found.extend(loaded.into_iter().filter(|library| *library != interface).map(|library| (interface, library)));
    }
    found.sort_unstable_by_key(|pair| (pair.0.manifest(db).path(db), pair.1.manifest(db).path(db)));
    found.dedup();
    found
}

/// Returns the problems of loading `library` under the identifier `alias` of a project, located at the identifier's
/// declaration.
pub fn stand_in_problems(db: &dyn Db, project: Project, alias: &SmolStr, library: Project) -> Vec<Problem> {
    let Some(place) = declarations::library(db, project, alias.clone()) else { return Vec::new() };
    let mut check = Interfaces::of(db, project);
    check.compare(alias, library, place);
    check.problems
}

/// How completely a library implements an interface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Fit {
    /// A used item is missing, or the interface is unknown.
    Lacks,
    /// All used items of the interface are present.
    Used,
    /// All public items of the interface are present.
    Whole,
}

/// Returns how completely `library` implements the interface that `alias` names in `project`.
pub fn fit(db: &dyn Db, project: Project, alias: &str, library: Project) -> Fit {
    let Some((alias, item)) = items(db, project).libraries.get_key_value(alias) else { return Fit::Lacks };
    let Some(interface) = item.interface else { return Fit::Lacks };
    let offers = |name: &SmolStr| implements(db, interface, library, name);
    let public = public_items(db, interface);
    if library == interface || !public.is_empty() && public.iter().all(offers) {
        return Fit::Whole;
    }
    let mut needed = Interfaces::of(db, project).needed(alias);
    needed.retain(|item| is_public(db, interface, item));
    if !needed.is_empty() && needed.iter().all(offers) { Fit::Used } else { Fit::Lacks }
}

/// Returns the names of the public data and programs of a project.
fn public_items(db: &dyn Db, project: Project) -> Vec<SmolStr> {
    let items = items(db, project);
    let names = items.data.keys().chain(items.programs.keys());
    names.filter(|name| is_public(db, project, name)).cloned().collect()
}

/// Whether the project has data or a program for each name.
fn has_items(db: &dyn Db, project: Project, names: &[SmolStr]) -> bool {
    let items = items(db, project);
    names.iter().all(|name| items.data.contains_key(name) || items.programs.contains_key(name))
}

/// Whether the project has public data or a public program called `item`.
pub fn is_public(db: &dyn Db, project: Project, item: &str) -> bool {
    let items = items(db, project);
    match items.data.get(item) {
        Some(data) => data.decl.public,
        None => items.programs.get(item).is_some_and(|file| header(db, *file).public),
    }
}

struct Interfaces<'db> {
    db: &'db dyn Db,
    project: Project,
    programs: Vec<(File, &'db LibraryUses)>,
    problems: Vec<Problem>,
}

impl<'db> Interfaces<'db> {
    fn of(db: &'db dyn Db, project: Project) -> Self {
        let programs = program_files(db, project).iter().map(|file| (*file, uses(db, *file))).collect();
        Self { db, project, programs, problems: Vec::new() }
    }
}

impl Interfaces<'_> {
    /// Reports an identifier that is used but loaded neither with the application nor by a program.
    fn never_loaded(&mut self, alias: &SmolStr) {
        let autoload = items(self.db, self.project).libraries.get(alias).is_none_or(|item| item.autoload);
        let loaded = self.programs.iter().any(|(_, uses)| uses.loads.iter().any(|load| load.alias == *alias));
        let used = self.programs.iter().any(|(_, uses)| uses.items.iter().any(|(used, _)| used == alias));
        if autoload || loaded || !used {
            return;
        }
        if let Some(place) = declarations::library(self.db, self.project, alias.clone()) {
            let kind = ProblemKind::LibraryNeverLoaded { alias: alias.clone() };
            self.problems.push(Problem { kind, place, related: Vec::new() });
        }
    }

    /// Checks every library that a program loads under the identifier by a constant path.
    fn loads(&mut self, alias: &SmolStr) {
        let mut compared = FxHashSet::default();
        let loads: Vec<(File, Load)> = self
            .programs
            .iter()
            .flat_map(|(file, uses)| uses.loads.iter().map(|load| (*file, load.clone())))
            .filter(|(_, load)| load.alias == *alias)
            .collect();
        for (file, load) in loads {
            let place = FileRange { file, range: load.range };
            for library in self.candidates(alias, place, &load.path) {
                if compared.insert(library) {
                    self.compare(alias, library, place);
                }
            }
        }
    }

    /// Returns the projects that programs load under the identifier. For a computed path, every project that has all
    /// used items of the interface is a candidate.
    fn loaded(&mut self, alias: &SmolStr) -> Vec<Project> {
        let uses = self.programs.iter().flat_map(|(file, uses)| uses.loads.iter().map(|load| (*file, load.clone())));
        let loads: Vec<(File, Load)> = uses.filter(|(_, load)| load.alias == *alias).collect();
        let mut found = Vec::new();
        for (file, load) in loads {
            match load.path {
                LoadedPath::Unknown => found.extend(self.look_alikes(alias)),
                path => found.extend(self.candidates(alias, FileRange { file, range: load.range }, &path)),
            }
        }
        found
    }

    fn look_alikes(&self, alias: &SmolStr) -> Vec<Project> {
        let needed = self.needed(alias);
        if needed.is_empty() {
            return Vec::new();
        }
        let projects = Sources::get(self.db).projects(self.db).values().copied();
        projects.filter(|library| *library != self.project && has_items(self.db, *library, &needed)).collect()
    }

    fn candidates(&mut self, alias: &SmolStr, place: FileRange, path: &LoadedPath) -> Vec<Project> {
        let db = self.db;
        match path {
            LoadedPath::Unknown => Vec::new(),
            LoadedPath::Prefix { text: prefix, .. } => {
                let mut found = self.projects_from(prefix);
                found.retain(|library| self.resembles(alias, *library));
                found
            }
            LoadedPath::Whole(path) => {
                if let Some(found) = find_project(db, self.project, path) {
                    return vec![found];
                }
                if let Some(kind) = self.unresolved(path) {
                    self.problems.push(Problem { kind, place, related: Vec::new() });
                }
                Vec::new()
            }
        }
    }

    /// Returns the fault of a path without a project; `None` if the application saves a library there, or if the project
    /// may be on a medium that is not available here.
    fn unresolved(&self, path: &SmolStr) -> Option<ProblemKind> {
        let roots = self.project.roots(self.db);
        match paths::project(folder(self.db, self.project), roots, path) {
            ResolvedPath::Path(target) if saved_libraries::is_saved(self.db, self.project, &target) => None,
            ResolvedPath::Path(_) => Some(ProblemKind::LibLoadPath(path.clone())),
            ResolvedPath::Elsewhere => {
                let root = paths::root(path);
                let near = Some(paths::near_root(root, roots)?);
                let (path, root) = (path.clone(), root.into());
                Some(ProblemKind::UnresolvedPath { what: FileRole::Library, path, root, near })
            }
        }
    }

    /// Whether the project has at least one used item of the interface, unlike an application in the libraries' folder.
    fn resembles(&self, alias: &SmolStr, library: Project) -> bool {
        let offered = items(self.db, library);
        let offers = |item: &SmolStr| offered.data.contains_key(item) || offered.programs.contains_key(item);
        self.needed(alias).iter().any(offers)
    }

    /// Returns the projects whose folder begins with a constant prefix, as in `"Disk://parts/part" + sName`.
    fn projects_from(&self, prefix: &str) -> Vec<Project> {
        let db = self.db;
        let roots = self.project.roots(db);
        let Some((start, partial)) = paths::projects_from(folder(db, self.project), roots, prefix) else {
            return Vec::new();
        };
        let start = path_key(start.as_str());
        let sources = Sources::get(db);
        let mut found: Vec<(&String, Project)> = sources
            .projects(db)
            .iter()
            .filter(|(key, _)| {
                let rest = key.strip_prefix(&start).and_then(|rest| rest.strip_prefix('/'));
                // Only direct children: `partbox/partbox.pjx`, but no deeper folder.
                rest.is_some_and(|rest| rest.starts_with(&partial) && rest.matches('/').count() == 1)
            })
            .map(|(key, project)| (key, *project))
            .collect();
        found.sort_unstable_by_key(|(key, _)| *key);
        found.into_iter().map(|(_, project)| project).collect()
    }
}
