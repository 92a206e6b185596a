//! Checks that applications declare the library aliases in `[test] replace`.

use std::collections::{BTreeMap, BTreeSet};

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, Sources};
use val3_analysis::items::project::items;
use val3_analysis::load::{LoadError, Workspace, load};
use val3_analysis::paths::path_key;
use val3_analysis::system::Disk;
use val3_config::{ConfigError, ConfigFile};
use val3_lang::suggest::{nearest, question};
use val3_session::SessionError;

use crate::user_error::UserError;

/// Checks the configurations of applications with tests.
///
/// # Errors
/// Neither a requested application nor an application in the folder of the configuration declares an alias.
pub(super) fn check(workspace: &Workspace, manifests: &[Utf8PathBuf]) -> Result<(), UserError> {
    let unknown: Vec<ConfigError> =
        configurations(&workspace.db, manifests).into_iter().flat_map(|file| unknown(&workspace.db, file)).collect();
    if unknown.is_empty() { Ok(()) } else { Err(SessionError::Load(LoadError::Configuration(unknown)).into()) }
}

/// Checks the file of a test.
///
/// # Errors
/// No project that its application loads declares an alias.
pub(super) fn check_file(db: &Database, replace: &BTreeMap<String, String>) -> Result<(), UserError> {
    let declared = declared(db);
    let Some(unknown) = replace.keys().find(|identifier| !declared.contains(*identifier)) else { return Ok(()) };
    let (message, help) = wording(unknown, &declared);
    Err(UserError::new(format!("`replace`: {message}")).with_help(help))
}

/// Configurations of applications, sorted by path.
fn configurations<'db>(db: &'db Database, manifests: &[Utf8PathBuf]) -> Vec<&'db ConfigFile> {
    let projects = Sources::get(db).projects(db);
    let project = |manifest: &Utf8PathBuf| projects.get(&path_key(manifest.as_str())).copied();
    let files = manifests.iter().filter_map(project).filter_map(|project| project.configuration(db));
    let by_path: BTreeMap<&Utf8Path, &ConfigFile> =
        files.map(|configuration| configuration.file(db)).map(|file| (file.path.as_path(), file)).collect();
    by_path.into_values().collect()
}

/// Faults of unknown aliases in a configuration.
fn unknown(db: &Database, file: &ConfigFile) -> Vec<ConfigError> {
    let mut declared = declared(db);
    let is_unknown = |declared: &BTreeSet<String>, identifier: &str| !declared.contains(identifier);
    let identifiers = || file.config.test.replace.keys();
    if !identifiers().any(|identifier| is_unknown(&declared, identifier)) {
        return Vec::new();
    }
    // An application that was not requested may declare the alias.
    if let Ok(all) = load(&Disk, &[file.folder().to_owned()]) {
        declared.extend(self::declared(&all.db));
    }
    let unknown = identifiers().filter(|identifier| is_unknown(&declared, identifier));
    unknown.map(|identifier| fault(file, identifier, &declared)).collect()
}

/// Library aliases of all projects.
fn declared(db: &Database) -> BTreeSet<String> {
    Sources::get(db)
        .projects(db)
        .values()
        .flat_map(|project| items(db, *project).libraries.keys().map(ToString::to_string))
        .collect()
}

fn fault(file: &ConfigFile, identifier: &str, declared: &BTreeSet<String>) -> ConfigError {
    let (message, help) = wording(identifier, declared);
    file.fault(&format!("test.replace.{identifier}"), message, help)
}

/// Message and help for an unknown alias.
fn wording(identifier: &str, declared: &BTreeSet<String>) -> (String, String) {
    let proposal = question(nearest(identifier, declared.iter().map(String::as_str)));
    let help = proposal.unwrap_or_else(|| "write an identifier of <Libraries> as programs use it".to_owned());
    (format!("no application declares the library identifier `{identifier}`"), help)
}
