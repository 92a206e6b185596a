//! Two folders or two files.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::system::{Disk, PathKind, System as _};
use val3_diff::FileTree;
use val3_files::is_archive_name;

use super::compared_versions::ComparedVersions;
use super::folder;
use crate::loose::archives_under;
use crate::paths::{Paths, current_folder, has_extension};
use crate::user_error::UserError;

/// File extensions by root element.
const ROOTS: [(&str, &str); 6] = [
    ("<Programs", "pgx"),
    ("<programList", "pgx"),
    ("<Database", "dtx"),
    ("<dataList", "dtx"),
    ("<Project", "pjx"),
    ("<project", "pjx"),
];

/// Reads two versions from the disk.
pub(super) fn versions(current: &Utf8Path, old: &Utf8Path, new: &Utf8Path) -> Result<ComparedVersions, UserError> {
    let kinds = [kind(current, old)?, kind(current, new)?];
    let paths = [current.join(old), current.join(new)];
    let names = [old.to_string(), new.to_string()];
    let trees = match kinds {
        [Some(PathKind::Folder) | None, Some(PathKind::Folder) | None] => {
            [tree(&paths[0], kinds[0])?, tree(&paths[1], kinds[1])?]
        }
        [Some(PathKind::File) | None, Some(PathKind::File) | None] => files(&paths, kinds)?,
        [first, _] => projects(&paths, first == Some(PathKind::File))?,
    };
    Ok(ComparedVersions { trees, names })
}

/// Kind of a path; `None` for a version that does not exist.
fn kind(current: &Utf8Path, path: &Utf8Path) -> Result<Option<PathKind>, UserError> {
    if folder::is_absent(path) {
        return Ok(None);
    }
    match Disk.kind(&current.join(path)) {
        // An archive is compared as a folder.
        Some(PathKind::File) if is_archive_name(path) => Ok(Some(PathKind::Folder)),
        Some(kind) => Ok(Some(kind)),
        None => Err(UserError::new(format!("`{path}`: there is no such file or folder"))
            .with_help("name the two folders or files to compare; for a revision of git use --git")),
    }
}

fn tree(path: &Utf8Path, kind: Option<PathKind>) -> Result<FileTree, UserError> {
    if kind.is_none() {
        return Ok(FileTree::default());
    }
    let files = folder::files(path)?;
    if !files.iter().any(|(path, _)| FileTree::includes(path)) {
        let archives = if path.is_dir() { archives_under(&Disk, path) } else { Vec::new() };
        let help = match archives.first() {
            Some(archive) => format!("name the archive in it to compare it: `{}`", shown(&archive.path)?),
            None => {
                "name an application folder, a cell, or a folder that contains one (`.pjx`, `.dtx`, `.pgx`)".to_owned()
            }
        };
        let message = format!("`{}`: this folder contains no VAL 3 files", shown(path)?);
        return Err(UserError::new(message).with_help(help));
    }
    Ok(FileTree::new(files))
}

/// Path as the user would open it.
fn shown(path: &Utf8Path) -> Result<String, UserError> {
    Ok(Paths::new(&[], &current_folder()?).shown(path))
}

fn is_project(path: &Utf8Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("pjx"))
}

/// Reads two single files. Two project files mean their applications, unless one of the folders contains no other file,
/// as with the temporary files of git.
fn files(paths: &[Utf8PathBuf; 2], kinds: [Option<PathKind>; 2]) -> Result<[FileTree; 2], UserError> {
    if kinds.iter().all(Option::is_some) && paths.iter().all(|path| is_project(path)) {
        let [old, new] = [application(&paths[0])?, application(&paths[1])?];
        if old.len() > 1 && new.len() > 1 {
            return Ok([old, new]);
        }
    }
    let mut contents = [None, None];
    for ((path, kind), content) in paths.iter().zip(kinds).zip(&mut contents) {
        if kind.is_some() {
            *content = Some(folder::read(path, &shown(path)?)?);
        }
    }
    let [old, new] = &contents;
    let named = |path: &Utf8Path, bytes: &Option<Vec<u8>>| bytes.as_ref().map(|bytes| named_by_content(path, bytes));
    let name = named(&paths[1], new).or(named(&paths[0], old)).unwrap_or_default();
    let name = Utf8PathBuf::from(name.file_name().unwrap_or("file"));
    if !FileTree::includes(&name) && !FileTree::includes(&Utf8Path::new("configs").join(&name)) {
        return Err(UserError::new(format!("`{}` is not a VAL 3 file", shown(&paths[1])?))
            .with_help("compare a `.pjx`, `.dtx`, `.pgx` or `.cfx`, or a folder with such files"));
    }
    let key = if FileTree::includes(&name) { name } else { Utf8Path::new("configs").join(name) };
    let [old, new] = contents;
    Ok([FileTree::new(old.map(|bytes| (key.clone(), bytes))), FileTree::new(new.map(|bytes| (key, bytes)))])
}

/// Reads a folder and the application of a project file.
fn projects(paths: &[Utf8PathBuf; 2], is_first_file: bool) -> Result<[FileTree; 2], UserError> {
    let [old, new] = paths;
    let file = if is_first_file { old } else { new };
    if !is_project(file) {
        return Err(UserError::new(format!("a file cannot be compared with a folder: `{}`", shown(file)?))
            .with_help("name two folders, or two files"));
    }
    let folder = |path: &Utf8Path| tree(path, Some(PathKind::Folder));
    Ok(if is_first_file { [application(old)?, folder(new)?] } else { [folder(old)?, application(new)?] })
}

/// Reads the folder of a project file.
fn application(path: &Utf8Path) -> Result<FileTree, UserError> {
    tree(path.parent().unwrap_or(Utf8Path::new(".")), Some(PathKind::Folder))
}

/// Path with the file extension of the content, because temporary files have other extensions.
pub(super) fn named_by_content(path: &Utf8Path, bytes: &[u8]) -> Utf8PathBuf {
    if FileTree::includes(path) || has_extension(path, "cfx") {
        return path.to_owned();
    }
    let head = String::from_utf8_lossy(bytes.get(..bytes.len().min(2000)).unwrap_or(bytes));
    let found = ROOTS.iter().find(|(root, _)| head.contains(root));
    found.map_or_else(|| path.to_owned(), |(_, extension)| path.with_extension(extension))
}
