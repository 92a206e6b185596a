//! Search for the projects under a path.

use camino::{Utf8Path, Utf8PathBuf};
use val3_files::{FileClass, is_archive_name};

use super::error::LoadError;
use super::search::{files, has_extension};
use crate::system::{PathKind, System};

/// Returns the `.pjx` files under `path`: a project file, an application folder, a cell, or any folder above.
pub(super) fn manifests(
    system: &dyn System,
    path: &Utf8Path,
    unreadable: &mut Vec<(Utf8PathBuf, String)>,
) -> Result<Vec<Utf8PathBuf>, LoadError> {
    let before = unreadable.len();
    let found = match system.kind(path) {
        None => return Err(error(path, &missing(system, path))),
        Some(PathKind::File) => of_file(system, path)?,
        Some(PathKind::Folder) => files(system, path, "pjx", unreadable),
    };
    if found.is_empty() {
        if let Some((entry, reason)) = unreadable.get(before) {
            return Err(error(entry, &format!("it cannot be read: {reason}")));
        }
        return Err(LoadError::NoApplication { folder: path.to_owned() });
    }
    Ok(found)
}

/// Returns the reason why a path does not exist; often a folder above it cannot be read.
fn missing(system: &dyn System, path: &Utf8Path) -> String {
    match system.read(path, FileClass::Program) {
        Err(reason) if !reason.is_missing() => format!("it cannot be read: {reason}"),
        _ => "there is no such file or folder".to_owned(),
    }
}

fn error(path: &Utf8Path, reason: &str) -> LoadError {
    LoadError::Path { path: path.to_owned(), reason: reason.to_owned() }
}

/// Returns a `.pjx` itself; for a program or data file, the project in its folder.
fn of_file(system: &dyn System, path: &Utf8Path) -> Result<Vec<Utf8PathBuf>, LoadError> {
    if is_manifest(path) {
        return Ok(vec![path.to_owned()]);
    }
    if is_archive_name(path) {
        return Err(error(path, "this command reads unpacked folders only; unpack the archive, and name its folder"));
    }
    if !has_extension(path, "pgx") && !has_extension(path, "dtx") {
        return Err(error(path, "this is not a VAL 3 file; name a `.pjx`, or the folder of an application"));
    }
    let folder = path.parent().unwrap_or(Utf8Path::new("."));
    let names = system.list(folder).map_err(|reason| error(folder, &format!("the folder cannot be read: {reason}")))?;
    let beside: Vec<_> = names.iter().map(|name| folder.join(name)).filter(|path| is_manifest(path)).collect();
    if beside.is_empty() {
        return Err(error(path, "there is no `.pjx` next to this file, so its application is not known"));
    }
    Ok(beside)
}

fn is_manifest(path: &Utf8Path) -> bool {
    has_extension(path, "pjx")
}
