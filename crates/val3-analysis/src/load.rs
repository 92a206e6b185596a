//! The loader: finds applications, and reads their files and the libraries and types that they use.

mod budget;
mod cells;
mod configuration;
mod discover;
mod disk;
mod error;
mod files;
mod folder_names;
mod known_inputs;
mod outside;
mod pages;
mod references;
mod refresh;
mod search;
mod surroundings;
mod unlisted;

use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use val3_config::ConfigError;
use val3_files::ProcessLimits;

pub use self::cells::cell_io;
pub use self::configuration::{nearest_configuration, request_configuration};
pub use self::error::{LoadError, NO_APPLICATION};
pub use self::outside::{cell_around, is_below_tests, leads_outside, refused_link};
pub use self::references::loads_alike;
pub use self::search::{files, loose_files};
pub use self::surroundings::names_meshes_alike;
use crate::cell::CellConfig;
use crate::db::{CellFolder, Configuration, Database, File, Project};
use crate::items::manifest::{Manifest, manifest};
use crate::paths::{self, ResolvedPath, Roots, path_key};

use crate::system::System;
use budget::Budget;
use folder_names::FolderNames;
use known_inputs::KnownInputs;
use outside::OutsideFolders;
use references::PathArgument;

/// Result of loading paths.
#[derive(Debug)]
pub struct Workspace {
    /// Database with all files.
    pub db: Database,
    /// Projects under the requested paths, sorted by path. Only these projects are checked.
    pub projects: Vec<Project>,
    /// Folders and entries under the requested paths that cannot be read, with the reason.
    pub unreadable: Vec<(Utf8PathBuf, String)>,
}

/// Finds the projects under `paths` and reads them with all their references.
///
/// # Errors
/// If a path does not exist, contains no project or is a file of no project, if a `val3.toml` is invalid, or if the
/// programs and data exceed the size limit of a workspace.
pub fn load(system: &dyn System, paths: &[Utf8PathBuf]) -> Result<Workspace, LoadError> {
    load_into(Database::default(), system, paths)
}

/// Like [`load`], into an empty database.
///
/// # Errors
/// As for [`load`].
pub fn load_into(db: Database, system: &dyn System, paths: &[Utf8PathBuf]) -> Result<Workspace, LoadError> {
    let mut loader = Loader::new(db, system, KnownInputs::default(), &|_| true);
    let mut manifests = Vec::new();
    for path in paths {
        manifests.extend(loader.discover(&paths::normalise(path))?);
    }
    let asked = loader.read(manifests);
    if !loader.config_errors.is_empty() {
        return Err(LoadError::Configuration(loader.config_errors));
    }
    if let Some((path, reason)) = loader.budget.excess() {
        return Err(LoadError::Path { path, reason });
    }
    Ok(loader.finish(&asked))
}

/// The `usr` folder and the configuration from which a cell is read.
type CellKey = (Option<Utf8PathBuf>, Option<Configuration>);

/// A project that another project loads.
struct LoadedProject {
    manifest: Utf8PathBuf,
    /// Folder of `Disk://` of the loading project.
    disk: Option<Utf8PathBuf>,
}

struct Loader<'s> {
    system: &'s dyn System,
    db: Database,
    /// Inputs of the previous load, for reuse.
    known: KnownInputs,
    /// Whether the known file with this path key must be read again.
    is_stale: &'s dyn Fn(&str) -> bool,
    files: FxHashMap<String, File>,
    /// Unlisted programs and data in project folders, by path key.
    unlisted: FxHashMap<String, File>,
    projects: FxHashMap<String, Project>,
    /// Projects in the order of loading.
    order: Vec<(String, Project)>,
    cells: FxHashMap<CellKey, Option<CellFolder>>,
    /// Applicable `val3.toml`, by the path key of the folder.
    configurations: FxHashMap<String, Option<Configuration>>,
    config_errors: Vec<ConfigError>,
    folders: FxHashMap<Utf8PathBuf, FolderNames>,
    /// Folder of `Disk://` for projects that are applications, by path key.
    own_disks: FxHashMap<String, Option<Utf8PathBuf>>,
    queue: Vec<LoadedProject>,
    unreadable: Vec<(Utf8PathBuf, String)>,
    budget: Budget,
}

impl<'s> Loader<'s> {
    fn new(db: Database, system: &'s dyn System, known: KnownInputs, is_stale: &'s dyn Fn(&str) -> bool) -> Self {
        Self {
            system,
            db,
            known,
            is_stale,
            files: FxHashMap::default(),
            unlisted: FxHashMap::default(),
            projects: FxHashMap::default(),
            order: Vec::new(),
            cells: FxHashMap::default(),
            configurations: FxHashMap::default(),
            config_errors: Vec::new(),
            folders: FxHashMap::default(),
            own_disks: FxHashMap::default(),
            queue: Vec::new(),
            unreadable: Vec::new(),
            budget: Budget::new(ProcessLimits::workspace()),
        }
    }

    /// Reads these projects and all their references. Returns the path keys of the projects.
    fn read(&mut self, mut manifests: Vec<Utf8PathBuf>) -> FxHashSet<String> {
        manifests.sort_unstable();
        manifests.dedup();
        self.read_projects_ahead(&manifests);
        for path in self.applications_first(&manifests) {
            self.application(path);
        }
        manifests.iter().map(|path| path_key(path.as_str())).collect()
    }

    /// Reads the application at `path` and all projects that it loads. They share its folder of `Disk://`.
    fn application(&mut self, path: &Utf8Path) {
        self.project(path, None);
        while let Some(LoadedProject { manifest, disk }) = self.queue.pop() {
            self.project(&manifest, disk.as_deref());
        }
    }

    fn finish(mut self, asked: &FxHashSet<String>) -> Workspace {
        let mut projects: Vec<(String, Project)> =
            std::mem::take(&mut self.order).into_iter().filter(|(key, _)| asked.contains(key)).collect();
        projects.sort_unstable_by(|a, b| a.0.cmp(&b.0));
        self.read_unlisted();
        self.store_sources();
        let projects = projects.into_iter().map(|(_, project)| project).collect();
        self.unreadable.extend(self.budget.excess());
        Workspace { db: self.db, projects, unreadable: self.unreadable }
    }

    /// Reads the project at `path` and its files, and queues the referenced projects. `disk` is the folder of `Disk://`
    /// of the loading project.
    fn project(&mut self, path: &Utf8Path, disk: Option<&Utf8Path>) {
        let key = path_key(path.as_str());
        if self.projects.contains_key(&key) {
            return;
        }
        let Some(file) = self.found_file(path) else { return };
        let path = file.path(&self.db).clone();
        let manifest = manifest(&self.db, file).clone();
        let folder = path.parent().unwrap_or(Utf8Path::new("")).to_owned();
        let mut outside = self.files_outside(&folder, &manifest);
        let loaded = self.files_of(&folder, &manifest, &outside);
        let mut named = manifest.projects();
        named.extend(loaded.iter().filter_map(PathArgument::whole));
        let configuration = self.configuration(&folder);
        let roots = self.roots(&path, configuration, disk);
        let cell = self.cell(roots.disk.as_deref(), configuration);
        let reach = OutsideFolders::of(self.system, &folder, &roots);
        for reference in named {
            if !self.enqueue(&folder, &roots, &reach, reference) {
                outside.push(reference.into());
            }
        }
        self.enqueue_add_on_programs(configuration, &roots);
        let prefixes = loaded.iter().filter_map(PathArgument::prefix);
        prefixes.for_each(|prefix| self.enqueue_prefix(&folder, &roots, &reach, prefix));
        let beside = self.names_in(&folder);
        let pages = self.pages(&folder, &beside);
        let surroundings = self.surroundings(&folder, &manifest, configuration);
        let meshes = surroundings.map(|file| self.meshes(file, configuration)).unwrap_or_default();
        let is_below_tests = self.is_below_tests(&folder, &roots, configuration);
        let input = known_inputs::ProjectInput {
            file,
            roots,
            cell,
            beside,
            pages,
            surroundings,
            meshes,
            outside,
            configuration,
            is_below_tests,
        };
        let project = self.project_input(&key, input);
        self.projects.insert(key.clone(), project);
        self.order.push((key, project));
    }

    /// Whether the project's path contains a folder `tests` below the cell's folder, which contains `usr` or the folder
    /// of `Disk://`.
    fn is_below_tests(&self, folder: &Utf8Path, roots: &Roots, configuration: Option<Configuration>) -> bool {
        let above = folder.parent().unwrap_or(folder);
        let disk = roots.disk.as_deref().unwrap_or(above);
        let around = paths::usrapp(disk).and_then(Utf8Path::parent).unwrap_or(disk);
        let base = around.parent().unwrap_or(around);
        let configured = configuration.map(|configuration| configuration.file(&self.db).folder().to_owned());
        is_below_tests(self.system, above, configured.as_deref(), base)
    }

    /// Reads the files of many projects in one call, which is faster than reading them project by project.
    fn read_projects_ahead(&mut self, manifests: &[Utf8PathBuf]) {
        self.read_ahead(manifests);
        let mut named = Vec::new();
        for path in manifests {
            let Some(file) = self.found_file(path) else { continue };
            let folder = path.parent().unwrap_or(Utf8Path::new(""));
            let manifest = manifest(&self.db, file);
            let paths = manifest.data.iter().chain(&manifest.programs).map(|name| paths::file_in(folder, name));
            named.extend(paths.filter(|path| outside::is_in_folder(self.system, folder, path)));
        }
        self.read_ahead(&named);
    }

    /// Queues the referenced project. Returns whether the reference stays inside the reach.
    fn enqueue(&mut self, folder: &Utf8Path, roots: &Roots, reach: &OutsideFolders, reference: &str) -> bool {
        let ResolvedPath::Path(path) = paths::project(folder, roots, reference) else { return true };
        let is_inside = reach.contains(self.system, &path);
        if is_inside {
            self.queue.push(LoadedProject { manifest: path, disk: roots.disk.clone() });
        }
        is_inside
    }

    /// Returns the program and data files outside of the project's folder, as written in the project file.
    fn files_outside(&self, folder: &Utf8Path, manifest: &Manifest) -> Vec<SmolStr> {
        let listed = manifest.programs.iter().chain(&manifest.data);
        let mut outside = listed.cloned().collect::<Vec<_>>();
        outside.retain(|name| !outside::is_in_folder(self.system, folder, &paths::file_in(folder, name)));
        outside
    }

    /// Reads the programs and data of a project. Returns the paths of libraries that the programs load.
    fn files_of(&mut self, folder: &Utf8Path, manifest: &Manifest, outside: &[SmolStr]) -> Vec<PathArgument> {
        let [data, programs] = [&manifest.data, &manifest.programs].map(|references| {
            let inside = references.iter().filter(|reference| !outside.contains(reference));
            inside.map(|reference| paths::file_in(folder, reference)).collect::<Vec<_>>()
        });
        self.read_ahead(data.iter().chain(&programs));
        for path in &data {
            self.found_file(path);
        }
        let programs: Vec<File> = programs.iter().filter_map(|path| self.found_file(path)).collect();
        programs.iter().flat_map(|program| references::loaded_libraries(program.text(&self.db))).collect()
    }

    /// Queues every project whose folder begins with a constant prefix, as in `"Disk://parts/part" + sName`.
    fn enqueue_prefix(&mut self, folder: &Utf8Path, roots: &Roots, reach: &OutsideFolders, prefix: &str) {
        let Some((start, partial)) = paths::projects_from(folder, roots, prefix) else { return };
        let Some(start) = self.actual(&start) else { return };
        for name in self.names_in(&start).iter().filter(|name| path_key(name).starts_with(&partial)) {
            let manifest = start.join(name.as_str()).join(format!("{name}.pjx"));
            if self.is_file(&manifest) && reach.contains(self.system, &manifest) {
                self.queue.push(LoadedProject { manifest, disk: roots.disk.clone() });
            }
        }
    }

    /// Returns the root folders of paths for the project at `manifest`; `disk` is the folder of the loading project.
    fn roots(&mut self, manifest: &Utf8Path, configuration: Option<Configuration>, disk: Option<&Utf8Path>) -> Roots {
        let mut roots = configuration.map(|it| configuration::roots(it.file(&self.db))).unwrap_or_default();
        if roots.disk.is_none() {
            let certain = paths::usrapp(manifest).or(disk).map(Utf8Path::to_owned);
            roots.disk = certain.or_else(|| self.own_disk(manifest));
        }
        roots
    }

    fn cell(&mut self, disk: Option<&Utf8Path>, configuration: Option<Configuration>) -> Option<CellFolder> {
        let usr = disk.and_then(Utf8Path::parent).map(Utf8Path::to_owned);
        let key = (usr, configuration);
        if let Some(cell) = self.cells.get(&key) {
            return *cell;
        }
        let config = self.cell_config(key.0.as_deref(), configuration);
        let cell = config.map(|config| self.cell_input(&key, config));
        self.cells.insert(key, cell);
        cell
    }

    fn cell_config(&mut self, usr: Option<&Utf8Path>, configuration: Option<Configuration>) -> Option<CellConfig> {
        let arm = configuration.and_then(|configuration| configuration.file(&self.db).config.arm.as_ref()?.kind());
        let system = self.system;
        let own = usr.and_then(|usr| cells::read(system, usr, arm, |path| self.actual(path)));
        let named = self.named_add_ons(configuration);
        let described_arm = self.described_arm(configuration);
        if named.is_empty() && described_arm.is_none() {
            return own;
        }
        let mut config = own.unwrap_or_default();
        Arc::make_mut(&mut config.add_ons).extend(named);
        config.described_arm = described_arm;
        Some(config)
    }
}
