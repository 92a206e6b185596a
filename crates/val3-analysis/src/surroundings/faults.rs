//! Faults of a `cell.toml`, with the messages of a run.

use val3_cell::{Cell, CellError, CellFile};
use val3_config::{ConfigError, TableFile};

use super::links::hulls;
use super::loaded::{build, is_named};
use crate::db::{Db, File, FileStatus, Project, Sources};

/// Returns the faults of a `cell.toml` and of the links' meshes in its applications, each message once. A frame, tool
/// or signal that only some applications have is no fault, unless `[run] cell` names the file. `are_all_loaded` states
/// whether the database contains all applications of the file: otherwise a name that none of them has may belong to
/// another application.
pub fn cell_faults(db: &dyn Db, file: File, are_all_loaded: bool) -> Vec<ConfigError> {
    if let FileStatus::Unreadable(reason) = file.status(db) {
        let message = format!("the file cannot be read: {reason}");
        let (path, text, help) = (file.path(db).clone(), String::new(), String::new());
        return vec![ConfigError { path, text, range: 0..0, message, help }];
    }
    let table = match TableFile::<CellFile>::parse(file.path(db), file.text(db)) {
        Ok(table) => table,
        Err(error) => return vec![error],
    };
    let projects = surrounded(db, file);
    let built: Vec<Result<Cell, CellError>> =
        projects.iter().map(|project| build(db, *project, &table, is_named(db, *project))).collect();
    let mut errors: Vec<CellError> = Vec::new();
    for error in built.iter().filter_map(|built| built.as_ref().err()) {
        if !errors.contains(error) {
            errors.push(error.clone());
        }
    }
    if errors.is_empty() && are_all_loaded && lacks_everywhere(&built) {
        errors.extend(projects.first().and_then(|project| build(db, *project, &table, true).err()));
    }
    let own = errors.into_iter().map(|error| table.fault(&error.key, error.message, error.help));
    let mut faults: Vec<ConfigError> = own.collect();
    for fault in projects.iter().filter_map(|project| hulls(db, *project).err()) {
        if !faults.contains(&fault) {
            faults.push(fault);
        }
    }
    faults
}

/// Applications whose `cell.toml` is this file, sorted by path.
fn surrounded(db: &dyn Db, file: File) -> Vec<Project> {
    let projects = Sources::get(db).projects(db).values().copied();
    let mut projects: Vec<Project> = projects.filter(|project| project.surroundings(db) == Some(file)).collect();
    projects.sort_unstable_by_key(|project| project.manifest(db).path(db));
    projects
}

/// Whether a thing is missing in every application, because its carrier or one of its signals does not exist there.
fn lacks_everywhere(built: &[Result<Cell, CellError>]) -> bool {
    let mut missing = built.iter().flatten().map(|cell| &cell.missing);
    let Some(first) = missing.next() else { return false };
    let rest: Vec<&Vec<String>> = missing.collect();
    first.iter().any(|name| rest.iter().all(|missing| missing.contains(name)))
}
