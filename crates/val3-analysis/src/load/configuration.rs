//! The `val3.toml` of a project, and its effect on loading.

use std::sync::{Arc, OnceLock};

use camino::{Utf8Path, Utf8PathBuf};
use smol_str::{SmolStr, format_smolstr};
use val3_config::{ArmModel, ConfigError, ConfigFile, FILE_NAME};
use val3_files::FileClass;
use val3_kinematics::Arm;
use val3_lang::add_on::AddOnTable;

use super::{LoadError, LoadedProject, Loader, cells, discover, outside};
use crate::add_on_programs;
use crate::db::Configuration;
use crate::paths::{Roots, normalise, path_key};

use crate::system::{PathKind, System};

/// File that replaces the nearest `val3.toml` of all applications.
static REQUESTED: OnceLock<Utf8PathBuf> = OnceLock::new();

/// Replaces the nearest `val3.toml` of all applications in this process by a file. Only the first call has an effect.
pub fn request_configuration(path: Utf8PathBuf) {
    let _ = REQUESTED.set(path);
}

/// Returns the path roots in a configuration.
pub(super) fn roots(file: &ConfigFile) -> Roots {
    let others = file.config.roots.iter().map(|(root, folder)| (root.clone(), inside(file, folder)));
    Roots { disk: file.config.disk.as_ref().map(|disk| inside(file, disk)), others: others.collect() }
}

/// Resolves a path in a configuration, relative to the folder of the file.
fn inside(file: &ConfigFile, path: &Utf8Path) -> Utf8PathBuf {
    normalise(&file.folder().join(path))
}

/// Returns the nearest `val3.toml` in `folder` or above.
///
/// # Errors
/// If the file cannot be read or is invalid.
pub fn nearest_configuration(system: &dyn System, folder: &Utf8Path) -> Result<Option<ConfigFile>, ConfigError> {
    if let Some(path) = REQUESTED.get() {
        return read(system, path).transpose();
    }
    folder.ancestors().find_map(|folder| read(system, &folder.join(FILE_NAME))).transpose()
}

/// Reads a configuration; `None` if the file does not exist.
fn read(system: &dyn System, path: &Utf8Path) -> Option<Result<ConfigFile, ConfigError>> {
    if system.kind(path) != Some(PathKind::File) {
        return None;
    }
    let folder = path.parent().unwrap_or(Utf8Path::new(""));
    if let Some(reason) = outside::refused_link(system, folder, path) {
        return Some(Err(unreadable(path, &format!("is not read: {reason}"))));
    }
    let bytes = match system.read(path, FileClass::Settings) {
        Ok(bytes) => bytes,
        Err(error) => return Some(Err(unreadable(path, &format!("cannot be read: {error}")))),
    };
    let Ok(text) = String::from_utf8(bytes) else {
        return Some(Err(unreadable(path, "is not UTF-8")));
    };
    Some(ConfigFile::parse(path, &text).and_then(|file| outside::check(system, &file).map(|()| file)))
}

impl Loader<'_> {
    /// Returns the nearest `val3.toml` in `folder` or above.
    pub(super) fn configuration(&mut self, folder: &Utf8Path) -> Option<Configuration> {
        let path = REQUESTED.get().cloned().unwrap_or_else(|| folder.join(FILE_NAME));
        let key = path_key(if REQUESTED.get().is_some() { path.as_str() } else { folder.as_str() });
        if let Some(known) = self.configurations.get(&key) {
            return *known;
        }
        let found = match (self.read_configuration(&path), REQUESTED.get()) {
            (Some(file), _) => Some(self.configuration_input(file)),
            (None, Some(_)) => None,
            (None, None) => folder.parent().and_then(|parent| self.configuration(parent)),
        };
        self.configurations.insert(key, found);
        found
    }

    /// Reads a configuration. A faulty file is replaced by its previous content or an empty configuration, and
    /// [`load`](super::load) then fails.
    fn read_configuration(&mut self, path: &Utf8Path) -> Option<ConfigFile> {
        let file = match read(self.system, path)? {
            Ok(file) => file,
            Err(error) => return Some(self.faulty(path, error)),
        };
        let missing = missing_folders(self.system, &file);
        self.config_errors.extend(missing);
        Some(file)
    }

    fn faulty(&mut self, path: &Utf8Path, error: ConfigError) -> ConfigFile {
        self.config_errors.push(error);
        let before = self.known.configurations.get(&path_key(path.as_str()));
        let before = before.map(|configuration| configuration.file(&self.db).clone());
        before.unwrap_or_default()
    }

    /// Reads the add-on tables that a configuration names.
    pub(super) fn named_add_ons(&mut self, configuration: Option<Configuration>) -> Vec<AddOnTable> {
        let Some(configuration) = configuration else { return Vec::new() };
        let file = configuration.file(&self.db);
        let mut tables = Vec::new();
        let mut errors = Vec::new();
        for path in &file.config.add_ons {
            match cells::named_table(self.system, &inside(file, path)) {
                Ok(table) => tables.push(table),
                Err(reason) => {
                    let message = format!("the table of add-on instructions `{path}` cannot be read: {reason}");
                    errors.push(file.fault("add-ons", message, String::new()));
                }
            }
        }
        self.config_errors.extend(errors);
        tables
    }

    /// Queues the libraries of stand-in programs for add-on instructions.
    pub(super) fn enqueue_add_on_programs(&mut self, configuration: Option<Configuration>, roots: &Roots) {
        let Some(configuration) = configuration else { return };
        let file = configuration.file(&self.db);
        let libraries = add_on_programs::named(file).map(|(_, program)| add_on_programs::manifest_of(file, program));
        self.queue.extend(libraries.map(|manifest| LoadedProject { manifest, disk: roots.disk.clone() }));
    }

    /// Reads the arm file that a configuration names. A fault is reported only by features that need the arm.
    pub(super) fn described_arm(&self, configuration: Option<Configuration>) -> Option<Result<Arc<Arm>, SmolStr>> {
        let file = configuration?.file(&self.db);
        let ArmModel::File(path) = file.config.arm.as_ref()?.model()? else { return None };
        let failed = |reason| format_smolstr!("the arm of `{path}` cannot be used: {reason}");
        Some(cells::described_arm(self.system, &inside(file, path)).map(Arc::new).map_err(failed))
    }

    /// Returns the `.pjx` files under `path`, without files that a `val3.toml` excludes.
    pub(super) fn discover(&mut self, path: &Utf8Path) -> Result<Vec<Utf8PathBuf>, LoadError> {
        let mut found = discover::manifests(self.system, path, &mut self.unreadable)?;
        if self.system.kind(path) == Some(PathKind::File) {
            return Ok(found);
        }
        let mut excluding = None;
        found.retain(|manifest| {
            let excluded = self.exclusion(path, manifest);
            excluding = excluding.take().or(excluded.clone());
            excluded.is_none()
        });
        match (found.is_empty(), excluding) {
            (true, Some(config)) => Err(LoadError::Path {
                path: path.to_owned(),
                reason: format!("every application here is excluded by `exclude` in {config}; name one to check it"),
            }),
            _ => Ok(found),
        }
    }

    /// Returns the path of the configuration that excludes `manifest` from a search in `asked`. A path that is named
    /// explicitly is never excluded.
    fn exclusion(&mut self, asked: &Utf8Path, manifest: &Utf8Path) -> Option<Utf8PathBuf> {
        let folder = manifest.parent()?;
        let file = self.configuration(folder)?.file(&self.db);
        let named = folder == asked || file.excludes(asked);
        (file.excludes(manifest) && !named).then(|| file.path.clone())
    }
}

fn unreadable(path: &Utf8Path, reason: &str) -> ConfigError {
    ConfigError {
        path: path.to_owned(),
        text: String::new(),
        range: 0..0,
        message: format!("the configuration `{path}` {reason}"),
        help: String::new(),
    }
}

/// Returns errors for path roots whose folders do not exist.
fn missing_folders(system: &dyn System, file: &ConfigFile) -> Vec<ConfigError> {
    let config = &file.config;
    let disk = config.disk.iter().map(|disk| ("disk".to_owned(), disk));
    let others = config.roots.iter().map(|(root, folder)| (format!("roots.{root}"), folder));
    disk.chain(others)
        .filter(|(_, folder)| system.kind(&inside(file, folder)) != Some(PathKind::Folder))
        .map(|(key, folder)| {
            let help = format!("paths are relative to the folder of this file, `{}`", file.folder());
            file.fault(&key, format!("there is no folder `{folder}`"), help)
        })
        .collect()
}
