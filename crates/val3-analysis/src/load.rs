//! From folders to inputs: finds applications, reads their files and those of the libraries and types they use.

mod cells;
mod discover;
mod disk;
mod files;
mod references;

use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::{FxHashMap, FxHashSet};
use val3_syntax::view::View;

use crate::db::{Cell, Database, File, Project, Sources, path_key};
use crate::items::manifest::{self, Manifest};
use crate::paths::{self, Target};
use crate::system::{Kind, System};
use references::Loaded;

/// Everything that was found under some paths, ready to be asked.
#[derive(Debug)]
pub struct Workspace {
    /// The database with all files in it.
    pub db: Database,
    /// The projects under the paths asked for, by path: those that are to be judged.
    pub projects: Vec<Project>,
    /// Folders under the paths asked for that cannot be listed, with the reason.
    pub unreadable: Vec<(Utf8PathBuf, String)>,
}

/// A path that was asked for and cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LoadError {
    /// The path as it was given.
    pub path: Utf8PathBuf,
    /// What is wrong with it, and what to do.
    pub reason: String,
}

impl std::fmt::Display for LoadError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.path, self.reason)
    }
}

impl std::error::Error for LoadError {}

/// Finds the projects under `paths` and reads them with everything they refer to.
///
/// # Errors
/// If a path does not exist, holds no project, or is a file that belongs to none.
pub fn load(system: &dyn System, paths: &[Utf8PathBuf]) -> Result<Workspace, LoadError> {
    load_into(Database::default(), system, paths)
}

/// As [`load`], into a database that is empty so far.
///
/// # Errors
/// Those of [`load`].
pub fn load_into(db: Database, system: &dyn System, paths: &[Utf8PathBuf]) -> Result<Workspace, LoadError> {
    let mut loader = Loader::new(db, system);
    let mut manifests = Vec::new();
    for path in paths {
        manifests.extend(discover::manifests(system, &paths::normalise(path), &mut loader.unreadable)?);
    }
    manifests.sort_unstable();
    manifests.dedup();
    let asked: FxHashSet<String> = manifests.iter().map(|path| path_key(path.as_str())).collect();
    for path in manifests {
        loader.project(&path);
    }
    Ok(loader.finish(&asked))
}

struct Loader<'s> {
    system: &'s dyn System,
    db: Database,
    files: FxHashMap<String, File>,
    projects: FxHashMap<String, Project>,
    /// Projects in the order they were found.
    order: Vec<(String, Project)>,
    cells: FxHashMap<Utf8PathBuf, Option<Cell>>,
    folders: FxHashMap<Utf8PathBuf, FxHashMap<String, String>>,
    queue: Vec<Utf8PathBuf>,
    unreadable: Vec<(Utf8PathBuf, String)>,
}

impl<'s> Loader<'s> {
    fn new(db: Database, system: &'s dyn System) -> Self {
        Self {
            system,
            db,
            files: FxHashMap::default(),
            projects: FxHashMap::default(),
            order: Vec::new(),
            cells: FxHashMap::default(),
            folders: FxHashMap::default(),
            queue: Vec::new(),
            unreadable: Vec::new(),
        }
    }

    fn finish(mut self, asked: &FxHashSet<String>) -> Workspace {
        while let Some(path) = self.queue.pop() {
            self.project(&path);
        }
        let mut projects: Vec<(String, Project)> =
            self.order.into_iter().filter(|(key, _)| asked.contains(key)).collect();
        projects.sort_unstable_by(|a, b| a.0.cmp(&b.0));
        let _sources = Sources::builder(self.files, self.projects).durability(salsa::Durability::MEDIUM).new(&self.db);
        let projects = projects.into_iter().map(|(_, project)| project).collect();
        Workspace { db: self.db, projects, unreadable: self.unreadable }
    }

    /// Reads the project at `path` and its files, and queues the projects it refers to.
    fn project(&mut self, path: &Utf8Path) {
        let key = path_key(path.as_str());
        if self.projects.contains_key(&key) {
            return;
        }
        let Some(file) = self.found_file(path) else { return };
        let path = file.path(&self.db).clone();
        let text = Arc::clone(file.text(&self.db));
        let manifest = manifest::read(View::root(val3_syntax::parse(&text).green()));
        let folder = path.parent().unwrap_or(Utf8Path::new("")).to_owned();
        let loaded = self.files_of(&folder, &manifest);
        let mut named = manifest.projects();
        named.extend(loaded.iter().filter_map(Loaded::whole));
        let disk = disk::root(self.system, &folder, &named);
        let cell = self.cell(disk.as_deref());
        let beside = self.names_in(&folder);
        let project = Project::new(&self.db, file, disk.clone(), cell, beside);
        self.projects.insert(key.clone(), project);
        self.order.push((key, project));
        named.into_iter().for_each(|reference| self.enqueue(&folder, disk.as_deref(), reference));
        let prefixes = loaded.iter().filter_map(Loaded::prefix);
        prefixes.for_each(|prefix| self.enqueue_prefix(&folder, disk.as_deref(), prefix));
    }

    fn enqueue(&mut self, folder: &Utf8Path, disk: Option<&Utf8Path>, reference: &str) {
        if let Target::Path(path) = paths::project(folder, disk, reference) {
            self.queue.push(path);
        }
    }

    /// Reads the programs and data of a project; the libraries that the programs load.
    fn files_of(&mut self, folder: &Utf8Path, manifest: &Manifest) -> Vec<Loaded> {
        let named = manifest.data.iter().chain(&manifest.programs);
        self.read_ahead(named.map(|reference| paths::file_in(folder, reference)).collect());
        for reference in &manifest.data {
            self.found_file(&paths::file_in(folder, reference));
        }
        let programs = manifest.programs.iter();
        let programs: Vec<File> =
            programs.filter_map(|reference| self.found_file(&paths::file_in(folder, reference))).collect();
        programs.iter().flat_map(|program| references::loaded_libraries(program.text(&self.db))).collect()
    }

    /// Queues every project whose folder begins as the code says: `"Disk://parts/part" + sName`.
    fn enqueue_prefix(&mut self, folder: &Utf8Path, disk: Option<&Utf8Path>, prefix: &str) {
        let Some((start, partial)) = paths::projects_from(folder, disk, prefix) else { return };
        for name in self.system.list(&start).unwrap_or_default() {
            let manifest = start.join(&name).join(format!("{name}.pjx"));
            if name.to_lowercase().starts_with(&partial) && self.system.kind(&manifest) == Some(Kind::File) {
                self.queue.push(manifest);
            }
        }
    }

    fn cell(&mut self, disk: Option<&Utf8Path>) -> Option<Cell> {
        let usr = disk?.parent()?.to_owned();
        if let Some(cell) = self.cells.get(&usr) {
            return *cell;
        }
        let config = cells::read(self.system, &usr);
        let cell = config.map(|config| Cell::builder(config).durability(salsa::Durability::MEDIUM).new(&self.db));
        self.cells.insert(usr, cell);
        cell
    }
}
