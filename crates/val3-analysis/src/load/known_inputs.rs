//! Inputs from an earlier load. They are reused, and set only if they differ, so that a second load invalidates only
//! queries that depend on a change.

use camino::Utf8Path;
use rustc_hash::FxHashMap;
use salsa::{Durability, Setter as _};
use smol_str::SmolStr;
use val3_config::ConfigFile;
use val3_files::FileClass;
use val3_syntax::encoding::Encoding;

use super::{CellKey, Loader};
use crate::cell::CellConfig;
use crate::db::{CellFolder, Configuration, Database, File, FileStatus, MeshFile, Project, Sources};
use crate::paths::{Roots, path_key};

use crate::system::DecodedFile;

/// Durability of stored files, which change less often than open documents. After an edit, salsa skips all queries that
/// depend only on stored files.
const STORED: Durability = Durability::MEDIUM;

/// Inputs of a workspace by key.
#[derive(Debug, Default)]
pub(super) struct KnownInputs {
    sources: Option<Sources>,
    /// Files by path key.
    pub(super) files: FxHashMap<String, File>,
    projects: FxHashMap<String, Project>,
    /// Configurations by the path key of the `val3.toml`.
    pub(super) configurations: FxHashMap<String, Configuration>,
    cells: FxHashMap<CellKey, CellFolder>,
    /// Meshes by path key.
    pub(super) meshes: FxHashMap<String, MeshFile>,
}

/// Parts of a project input.
pub(super) struct ProjectInput {
    pub(super) file: File,
    pub(super) roots: Roots,
    pub(super) cell: Option<CellFolder>,
    pub(super) beside: Vec<SmolStr>,
    pub(super) pages: Vec<File>,
    pub(super) surroundings: Option<File>,
    pub(super) meshes: Vec<MeshFile>,
    pub(super) outside: Vec<SmolStr>,
    pub(super) configuration: Option<Configuration>,
    pub(super) is_below_tests: bool,
}

impl KnownInputs {
    /// Collects the inputs of a database into which a workspace was loaded.
    pub(super) fn of(db: &Database) -> Self {
        let Some(sources) = Sources::try_get(db) else { return Self::default() };
        let projects = sources.projects(db).clone();
        let mut files = sources.unlisted(db).clone();
        files.extend(sources.files(db).iter().map(|(key, file)| (key.clone(), *file)));
        let mut known = Self { sources: Some(sources), files, ..Self::default() };
        for project in projects.values() {
            let configuration = project.configuration(db);
            if let Some(configuration) = configuration {
                known.configurations.insert(path_key(configuration.file(db).path.as_str()), configuration);
            }
            let meshes = project.meshes(db).iter();
            known.meshes.extend(meshes.map(|mesh| (path_key(mesh.path.as_str()), mesh.clone())));
            if let Some(cell) = project.cell(db) {
                let usr = project.disk(db).and_then(Utf8Path::parent).map(Utf8Path::to_owned);
                known.cells.insert((usr, configuration), cell);
            }
        }
        Self { projects, ..known }
    }
}

impl Loader<'_> {
    /// Returns the input for a file with this content.
    pub(super) fn file_input(&mut self, key: String, path: &Utf8Path, content: DecodedFile) -> File {
        let path = self.spelt(path);
        let known = self.known.files.get(&key).copied();
        // Open documents change often.
        let durability = if content.status.is_some() { STORED } else { Durability::LOW };
        let status = content.status.unwrap_or_else(|| self.stored_status(known, &key, &path));
        let file = match known {
            Some(file) => {
                if *file.path(&self.db) != path {
                    file.set_path(&mut self.db).with_durability(Durability::HIGH).to(path);
                }
                if **file.text(&self.db) != *content.text {
                    file.set_text(&mut self.db).with_durability(durability).to(content.text);
                }
                if *file.status(&self.db) != status {
                    file.set_status(&mut self.db).to(status);
                }
                file
            }
            None => File::builder(path, content.text, status)
                .durability(STORED)
                .text_durability(durability)
                .path_durability(Durability::HIGH)
                .new(&self.db),
        };
        self.files.insert(key, file);
        file
    }

    /// Returns the status of the stored file that is being edited. An unreadable file is treated as a new file.
    fn stored_status(&self, known: Option<File>, key: &str, path: &Utf8Path) -> FileStatus {
        let known = known.filter(|_| !(self.is_stale)(key)).map(|file| file.status(&self.db).clone());
        let status = known.or_else(|| DecodedFile::of(self.system.stored(path, FileClass::Program))?.status);
        let read = status.filter(|status| matches!(status, FileStatus::Read { .. }));
        read.unwrap_or(FileStatus::Read { encoding: Encoding::Utf8, mismatch: None })
    }

    pub(super) fn project_input(&mut self, key: &str, described: ProjectInput) -> Project {
        let ProjectInput {
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
        } = described;
        let Some(project) = self.known.projects.get(key).copied() else {
            let input = Project::builder(
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
            );
            return input.durability(STORED).new(&self.db);
        };
        let db = &mut self.db;
        if project.manifest(db) != file {
            project.set_manifest(db).to(file);
        }
        if *project.roots(db) != roots {
            project.set_roots(db).to(roots);
        }
        if project.cell(db) != cell {
            project.set_cell(db).to(cell);
        }
        if *project.beside(db) != beside {
            project.set_beside(db).to(beside);
        }
        if *project.pages(db) != pages {
            project.set_pages(db).to(pages);
        }
        if project.surroundings(db) != surroundings {
            project.set_surroundings(db).to(surroundings);
        }
        if *project.meshes(db) != meshes {
            project.set_meshes(db).with_durability(STORED).to(meshes);
        }
        if *project.outside(db) != outside {
            project.set_outside(db).to(outside);
        }
        if project.configuration(db) != configuration {
            project.set_configuration(db).to(configuration);
        }
        if project.is_below_tests(db) != is_below_tests {
            project.set_is_below_tests(db).to(is_below_tests);
        }
        project
    }

    pub(super) fn configuration_input(&mut self, file: ConfigFile) -> Configuration {
        let Some(configuration) = self.known.configurations.get(&path_key(file.path.as_str())).copied() else {
            return Configuration::builder(file).durability(STORED).new(&self.db);
        };
        if *configuration.file(&self.db) != file {
            configuration.set_file(&mut self.db).with_durability(STORED).to(file);
        }
        configuration
    }

    pub(super) fn cell_input(&mut self, key: &CellKey, config: CellConfig) -> CellFolder {
        let Some(cell) = self.known.cells.get(key).copied() else {
            return CellFolder::builder(config).durability(STORED).new(&self.db);
        };
        if *cell.config(&self.db) != config {
            cell.set_config(&mut self.db).with_durability(STORED).to(config);
        }
        cell
    }

    pub(super) fn store_sources(&mut self) {
        let (files, projects) = (std::mem::take(&mut self.files), std::mem::take(&mut self.projects));
        let unlisted = std::mem::take(&mut self.unlisted);
        let Some(sources) = self.known.sources else {
            let _ = Sources::builder(files, unlisted, projects).durability(STORED).new(&self.db);
            return;
        };
        self.forget_missing(&files, &unlisted);
        if *sources.files(&self.db) != files {
            sources.set_files(&mut self.db).with_durability(STORED).to(files);
        }
        if *sources.unlisted(&self.db) != unlisted {
            sources.set_unlisted(&mut self.db).with_durability(STORED).to(unlisted);
        }
        if *sources.projects(&self.db) != projects {
            sources.set_projects(&mut self.db).with_durability(STORED).to(projects);
        }
    }

    /// Clears the texts of files that no longer exist. Inputs themselves cannot be freed.
    fn forget_missing(&mut self, files: &FxHashMap<String, File>, unlisted: &FxHashMap<String, File>) {
        for (key, file) in &self.known.files {
            if !files.contains_key(key) && !unlisted.contains_key(key) {
                file.set_text(&mut self.db).to("".into());
            }
        }
    }
}
