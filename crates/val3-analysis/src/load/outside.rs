//! Boundary of a cell: paths in its settings and project files are used only if they are inside the cell after
//! resolving links.

use camino::{Utf8Path, Utf8PathBuf};
use val3_config::trust::{self, NamedPath};
use val3_config::{ConfigError, ConfigFile};
use val3_lang::test_names::TESTS;

use crate::paths::{Roots, normalise, with_manifest};
use crate::system::System;

/// Folders that mark the root of a repository.
const REPOSITORY: [&str; 3] = [".git", ".hg", ".svn"];

/// Returns the cell of the files in `folder`: the enclosing repository, otherwise the folder itself. Links are
/// resolved. The user's home is never a cell, even if it is a repository.
pub fn cell_around(system: &dyn System, folder: &Utf8Path) -> Utf8PathBuf {
    repository_around(system, folder).unwrap_or_else(|| system.target(folder))
}

/// Returns the repository that contains a folder, unless it is the user's home. Links are resolved.
pub(super) fn repository_around(system: &dyn System, folder: &Utf8Path) -> Option<Utf8PathBuf> {
    let folder = system.target(folder);
    let mut within_home = folder.ancestors().take_while(|folder| !trust::is_home(folder));
    within_home.find(|folder| is_repository(system, folder)).map(Utf8Path::to_owned)
}

fn is_repository(system: &dyn System, folder: &Utf8Path) -> bool {
    REPOSITORY.iter().any(|name| system.kind(&folder.join(name)).is_some())
}

/// Whether `folder` is below a folder `tests`, or is such a folder itself. Only folders inside the repository are
/// considered; without a repository, only folders below `base` or the folder of the `val3.toml`, because folders above
/// a cell do not describe it.
pub fn is_below_tests(
    system: &dyn System,
    folder: &Utf8Path,
    configuration: Option<&Utf8Path>,
    base: &Utf8Path,
) -> bool {
    let target = system.target(folder);
    let top = repository_around(system, folder).or_else(|| {
        let tops = configuration.into_iter().chain([base]).map(|top| system.target(top));
        tops.filter(|top| target.starts_with(top)).min_by_key(|top| top.components().count())
    });
    let below = top.and_then(|top| target.strip_prefix(top).ok());
    below.is_some_and(|below| below.components().any(|part| part.as_str() == TESTS))
}

/// Whether `path` is outside of `cell`, whose links are resolved.
pub fn leads_outside(system: &dyn System, cell: &Utf8Path, path: &Utf8Path) -> bool {
    !system.target(path).starts_with(cell)
}

/// Checks that the paths in a settings file stay in its cell, or that the user trusts the file.
///
/// # Errors
/// Reports the first setting whose path is outside.
pub(super) fn check(system: &dyn System, file: &ConfigFile) -> Result<(), ConfigError> {
    let named = file.named_paths();
    if named.is_empty() {
        return Ok(());
    }
    let cell = cell_around(system, file.folder());
    let outside = named.into_iter().find(|named| leads_outside(system, &cell, &path_to_check(file, named)));
    match outside {
        Some(named) if !trust::is_trusted(&system.target(file.folder())) => {
            Err(file.outside(&named.key, &format!("resolves to `{}`, outside of the cell", named.path), &cell))
        }
        _ => Ok(()),
    }
}

/// Returns the full path of a file or folder in a settings file; the folder around it for a library.
fn path_to_check(file: &ConfigFile, named: &NamedPath<'_>) -> Utf8PathBuf {
    let path = normalise(&file.folder().join(named.path));
    if named.is_library() { around_library(path) } else { path }
}

/// Returns the parent folder of a library's folder, which becomes a path root.
fn around_library(path: Utf8PathBuf) -> Utf8PathBuf {
    with_manifest(path).ancestors().nth(2).unwrap_or(Utf8Path::new("")).to_owned()
}

/// Whether a file that a project in `folder` names is in this folder. A link to a file elsewhere is rejected, unless
/// the user trusts the folder.
pub(super) fn is_in_folder(system: &dyn System, folder: &Utf8Path, path: &Utf8Path) -> bool {
    if path.parent() == Some(folder) && !system.is_link(path) {
        return true;
    }
    let real_folder = system.target(folder);
    path.starts_with(folder) && (!leads_outside(system, &real_folder, path) || trust::is_trusted(&real_folder))
}

/// Returns the reason why the link at `path` is not followed; `None` if the path is no link, if its target is inside
/// the cell of `folder`, or if the user trusts this folder.
pub fn refused_link(system: &dyn System, folder: &Utf8Path, path: &Utf8Path) -> Option<String> {
    if !system.is_link(path) || !leads_outside(system, &cell_around(system, folder), path) {
        return None;
    }
    let command = trust::trust_command(folder);
    let reason = || format!("it is a link out of the cell, which needs the user's trust: {command}");
    (!trust::is_trusted(&system.target(folder))).then(reason)
}

/// Folders in which libraries and user types of a project may be. Links are resolved.
pub(super) struct OutsideFolders {
    folders: Vec<Utf8PathBuf>,
    project: Utf8PathBuf,
}

impl OutsideFolders {
    /// Creates the reach of the project in `folder`: its cell, its parent folder and the path roots. If `Disk` is
    /// `usr/usrapp`, all of `usr` is included.
    pub(super) fn of(system: &dyn System, folder: &Utf8Path, roots: &Roots) -> Self {
        let disk = roots.disk.as_deref().map(|disk| usr_around(disk).unwrap_or(disk));
        let others = roots.others.iter().map(|(_, folder)| folder.as_path());
        let named = folder.parent().into_iter().chain(disk).chain(others).map(|folder| system.target(folder));
        let project = system.target(folder);
        Self { folders: named.chain([cell_around(system, folder)]).collect(), project }
    }

    /// Whether a project file may be used, because it is in one of the folders or the user trusts the project.
    pub(super) fn contains(&self, system: &dyn System, path: &Utf8Path) -> bool {
        let target = system.target(path);
        self.folders.iter().any(|folder| target.starts_with(folder)) || trust::is_trusted(&self.project)
    }
}

/// Returns the controller folder `usr` that contains the `usrapp`.
fn usr_around(disk: &Utf8Path) -> Option<&Utf8Path> {
    let is = |path: &Utf8Path, name: &str| path.file_name().is_some_and(|found| found.eq_ignore_ascii_case(name));
    disk.parent().filter(|usr| is(disk, "usrapp") && is(usr, "usr"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::Memory;

    fn system() -> Memory {
        Memory::new([("/w/.git/HEAD", ""), ("/w/tests/val3.toml", ""), ("/w/usr/a.pjx", ""), ("/x/val3.toml", "")])
    }

    #[test]
    fn a_cell_is_a_repository_or_a_folder() {
        let cell = |folder: &str| cell_around(&system(), folder.into()).into_string();
        assert_eq!(cell("/w/tests"), "/w");
        assert_eq!(cell("/w"), "/w");
        assert_eq!(cell("/x"), "/x");
    }

    fn checked(path: &str, text: &str) -> Result<(), String> {
        let file = ConfigFile::parse(path.into(), text).unwrap();
        check(&system(), &file).map_err(|error| error.message)
    }

    #[test]
    fn settings_stay_in_their_cell() {
        assert_eq!(checked("/w/tests/val3.toml", "disk = \"../usr\""), Ok(()));
        assert_eq!(checked("/x/val3.toml", "roots.A = \"a\"\nbaseline = \"sub/../b.json\""), Ok(()));
        let outside = |key: &str, path: &str| Err(format!("`{key}` resolves to `{path}`, outside of the cell"));
        assert_eq!(checked("/x/val3.toml", "disk = \"../w/usr\""), outside("disk", "../w/usr"));
        assert_eq!(checked("/w/tests/val3.toml", "add-ons = [\"/dev/zero\"]"), outside("add-ons", "/dev/zero"));
        assert_eq!(
            checked("/x/val3.toml", "run.shapes.base = \"/etc/a.stl\""),
            outside("run.shapes.base", "/etc/a.stl")
        );
        assert_eq!(checked("/x/val3.toml", "test.replace.p = \"/lib/p\""), outside("test.replace.p", "/lib/p"));
        assert_eq!(checked("/x/val3.toml", "test.replace.p = \"p\""), Ok(()));
        assert_eq!(checked("/x/val3.toml", "test.replace.p = \"p.pjx\""), outside("test.replace.p", "p.pjx"));
        assert_eq!(checked("/x/val3.toml", "arm = \"../own.toml\""), outside("arm", "../own.toml"));
    }

    #[test]
    fn files_of_a_project_are_in_its_folder() {
        let inside = |path: &str| is_in_folder(&system(), "/w/usr".into(), path.into());
        assert!(inside("/w/usr/a.pgx") && inside("/w/usr/sub/a.pgx"));
        assert!(!inside("/w/a.pgx") && !inside("/etc/passwd"));
    }
}
