//! Stand-ins: libraries that are loaded in place of others during tests (`[test] replace`).

use std::fmt;

use camino::{Utf8Path, Utf8PathBuf};
use smol_str::SmolStr;
use val3_analysis::db::{Db, Project, Sources};
use val3_analysis::interfaces::replacements;
use val3_analysis::items::project::{LibraryItem, items};
use val3_analysis::load::LoadError;
use val3_analysis::paths::{normalise, path_key, with_manifest};
use val3_analysis::system::{PathKind, System};
use val3_config::{ConfigError, ConfigFile};
use val3_lang::suggest::{nearest, question};

use crate::error::SessionError;

/// A library that is loaded under an identifier, in place of the library in the project files.
pub(crate) struct StandIn {
    pub(crate) identifier: SmolStr,
    pub(crate) project: Project,
    /// Path as spelled in the configuration.
    path: Utf8PathBuf,
}

/// Reason why a stand-in cannot replace a library.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StandInFault {
    /// Path as spelled in the configuration.
    pub path: Utf8PathBuf,
    /// The problem.
    pub message: String,
    /// The remedy; may be empty.
    pub help: String,
}

impl fmt::Display for StandInFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the stand-in `{}` cannot be used: {}", self.path, self.message)
    }
}

/// Project files of the stand-ins in a configuration.
///
/// # Errors
/// If a path contains no library.
pub(crate) fn manifests(system: &dyn System, file: &ConfigFile) -> Result<Vec<Utf8PathBuf>, SessionError> {
    let mut found = Vec::new();
    let mut missing = Vec::new();
    for (identifier, path) in &file.config.test.replace {
        let manifest = manifest(file, path);
        match system.kind(&manifest) {
            Some(PathKind::File) => found.push(manifest),
            _ => missing.push(no_library(system, file, identifier, path)),
        }
    }
    if missing.is_empty() { Ok(found) } else { Err(LoadError::Configuration(missing).into()) }
}

fn manifest(file: &ConfigFile, path: &Utf8Path) -> Utf8PathBuf {
    with_manifest(normalise(&file.folder().join(path)))
}

fn no_library(system: &dyn System, file: &ConfigFile, identifier: &str, path: &Utf8Path) -> ConfigError {
    let full = normalise(&file.folder().join(path));
    let beside = full.parent().and_then(|parent| system.list(parent).ok()).unwrap_or_default();
    let proposal = question(nearest(path.file_name().unwrap_or(""), beside.iter().map(String::as_str)));
    let rule = || format!("name the folder of a library or its `.pjx`, relative to `{}`", file.folder());
    let message = format!("there is no library `{path}`");
    file.fault(&format!("test.replace.{identifier}"), message, proposal.unwrap_or_else(rule))
}

/// Stand-ins in a configuration that were read.
pub(crate) fn stand_ins(db: &dyn Db, file: &ConfigFile) -> Vec<StandIn> {
    let projects = Sources::get(db).projects(db);
    let stand_ins = file.config.test.replace.iter().filter_map(|(identifier, path)| {
        let project = *projects.get(&path_key(manifest(file, path).as_str()))?;
        Some(StandIn { identifier: identifier.into(), project, path: path.clone() })
    });
    stand_ins.collect()
}

/// Reasons why stand-ins cannot replace an application's libraries.
pub(crate) fn faults(db: &dyn Db, application: Project, stand_ins: &[StandIn]) -> Vec<StandInFault> {
    let mut faults = Vec::new();
    for (user, library, stand_in) in replaced(db, application, stand_ins) {
        if library.interface.is_none() {
            faults.push(stand_in.without_interface(db, user));
        }
        let refusals = val3_check::refusals(db, stand_in.project);
        let misfits = val3_check::stand_in_faults(db, user, &stand_in.identifier, stand_in.project);
        let found = refusals.into_iter().take(1).chain(misfits);
        faults.extend(found.map(|found| stand_in.fault(found.message, found.help)));
    }
    faults
}

/// Library identifiers under which stand-ins are loaded, in all projects reachable from an application.
fn replaced<'a>(
    db: &'a dyn Db,
    application: Project,
    stand_ins: &'a [StandIn],
) -> Vec<(Project, &'a LibraryItem, &'a StandIn)> {
    let mut found = Vec::new();
    let mut reached = vec![application];
    let mut at = 0;
    while let Some(user) = reached.get(at).copied() {
        at += 1;
        let mut libraries: Vec<_> = items(db, user).libraries.iter().collect();
        libraries.sort_unstable_by_key(|(identifier, _)| *identifier);
        for (identifier, library) in libraries {
            let takes_place = |known: &&StandIn| known.identifier == *identifier && known.project != user;
            let stand_in = stand_ins.iter().find(takes_place);
            found.extend(stand_in.map(|stand_in| (user, library, stand_in)));
            let loaded = stand_in.map_or_else(|| loaded(db, user, library), |stand_in| vec![stand_in.project]);
            let new: Vec<Project> = loaded.into_iter().filter(|project| !reached.contains(project)).collect();
            reached.extend(new);
        }
    }
    found
}

/// Libraries that can be loaded under an identifier of `user`.
fn loaded(db: &dyn Db, user: Project, library: &LibraryItem) -> Vec<Project> {
    let others = replacements(db, user).iter().filter(|(interface, _)| Some(*interface) == library.interface);
    library.interface.into_iter().chain(others.map(|(_, other)| *other)).collect()
}

impl StandIn {
    fn fault(&self, message: String, help: String) -> StandInFault {
        StandInFault { path: self.path.clone(), message, help }
    }

    fn without_interface(&self, db: &dyn Db, user: Project) -> StandInFault {
        let user = user.manifest(db).path(db).file_stem().unwrap_or("");
        let message = format!(
            "the library that `{user}` declares as `{}` is missing, and it gives the interface",
            self.identifier
        );
        self.fault(message, "correct its path in <Libraries>, or add the library".to_owned())
    }
}
