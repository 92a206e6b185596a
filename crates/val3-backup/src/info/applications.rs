//! Applications of a controller: sizes and dates.

use std::collections::BTreeMap;

use super::cfx::joined;
use crate::{BackupFile, DateTime};

/// An application or a library.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ApplicationInfo {
    /// Name, which is the name of the project file.
    pub name: String,
    /// Path of the project file in the backup.
    pub path: String,
    /// Number of program files in its folder and in folders below.
    pub programs: usize,
    /// Number of all files in its folder and in folders below.
    pub files: usize,
    /// Size of all files in bytes.
    pub size: u64,
    /// Time of the last change of a file, if the backup has kept it.
    pub modified: Option<DateTime>,
}

/// Returns the applications in `usrapp`, sorted by path. If the backup has no `usrapp`, all projects are returned.
pub(super) fn applications(files: &[BackupFile], usr: &str) -> Vec<ApplicationInfo> {
    let usrapp = joined(usr, "usrapp/").to_ascii_lowercase();
    let is_inside = |path: &str| path.to_ascii_lowercase().starts_with(&usrapp);
    let has_usrapp = files.iter().any(|file| is_inside(&file.path));
    let files: Vec<&BackupFile> = files.iter().filter(|file| !has_usrapp || is_inside(&file.path)).collect();
    let mut folders: BTreeMap<&str, Vec<ApplicationInfo>> = BTreeMap::new();
    for file in &files {
        let (folder, name) = split(&file.path);
        let Some((name, _)) = name.rsplit_once('.').filter(|(_, extension)| is(extension, "pjx")) else { continue };
        folders.entry(folder).or_default().push(empty(name, &file.path));
    }
    for file in files {
        // A folder with two projects is unusual: its files count for both.
        let folder = ancestors(&file.path).find(|folder| folders.contains_key(folder));
        for application in folder.and_then(|folder| folders.get_mut(folder)).into_iter().flatten() {
            add(application, file);
        }
    }
    folders.into_values().flatten().collect()
}

fn empty(name: &str, path: &str) -> ApplicationInfo {
    ApplicationInfo { name: name.to_owned(), path: path.to_owned(), programs: 0, files: 0, size: 0, modified: None }
}

fn add(application: &mut ApplicationInfo, file: &BackupFile) {
    let is_program = file.path.rsplit_once('.').is_some_and(|(_, extension)| is(extension, "pgx"));
    application.programs += usize::from(is_program);
    application.files += 1;
    application.size = application.size.saturating_add(file.size);
    application.modified = application.modified.max(file.modified);
}

fn is(extension: &str, known: &str) -> bool {
    extension.eq_ignore_ascii_case(known)
}

fn split(path: &str) -> (&str, &str) {
    path.rsplit_once('/').unwrap_or(("", path))
}

/// Returns the folders above a path, the nearest first, up to the root.
fn ancestors(path: &str) -> impl Iterator<Item = &str> {
    std::iter::successors(Some(split(path).0), |folder| (!folder.is_empty()).then(|| split(folder).0))
}
