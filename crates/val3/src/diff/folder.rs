//! Reads the files of a folder.

use std::collections::BTreeSet;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::load::refused_link;
use val3_analysis::system::{Disk, PathKind, System as _};
use val3_diff::FileTree;
use val3_files::{FileClass, unpack};

use super::wanted::is_hidden;
use crate::user_error::UserError;

/// Maximum depth of searched folders.
const DEPTH: usize = 32;

/// File names that git passes for a version without the file.
const ABSENT: [&str; 3] = ["/dev/null", "NUL", "nul"];

/// Whether the path means a version that does not exist.
pub(super) fn is_absent(path: &Utf8Path) -> bool {
    ABSENT.contains(&path.as_str())
}

/// Returns the files in `folder` or in the archive at this path, by their relative paths. Omits files and folders whose
/// names begin with a dot, because they belong to other tools.
pub(super) fn files(folder: &Utf8Path) -> Result<Vec<(Utf8PathBuf, Vec<u8>)>, UserError> {
    if folder.is_file() {
        let fault = |fault| UserError::new(format!("cannot read the archive `{folder}`: {fault}"));
        return unpack(folder, |path| !is_hidden(path)).map_err(fault);
    }
    let mut search = FolderWalk { root: folder, found: Vec::new(), seen: BTreeSet::new() };
    search.folder(folder, 0)?;
    let mut files = Vec::new();
    for (key, path) in search.found.iter().filter(|(key, _)| FileTree::includes(key) || !is_hidden(key)) {
        files.push((key.clone(), read(path, path.as_str())?));
    }
    Ok(files)
}

struct FolderWalk<'f> {
    root: &'f Utf8Path,
    /// Files with their paths relative to the root.
    found: Vec<(Utf8PathBuf, Utf8PathBuf)>,
    /// Folders already searched, so that circular links end.
    seen: BTreeSet<Utf8PathBuf>,
}

impl FolderWalk<'_> {
    fn folder(&mut self, folder: &Utf8Path, depth: usize) -> Result<(), UserError> {
        if !self.seen.insert(Disk.identity(folder)) {
            return Ok(());
        }
        if depth > DEPTH {
            return Err(UserError::new(format!("`{folder}` is not compared: it lies more than {DEPTH} folders deep"))
                .with_help("name it to compare it"));
        }
        let names = Disk.list(folder);
        let names = names.map_err(|error| UserError::new(format!("the folder `{folder}` cannot be read: {error}")))?;
        for name in names {
            let path = folder.join(&name);
            if let Some(reason) = refused_link(&Disk, self.root, &path) {
                return Err(UserError::new(format!("`{path}` is not compared: {reason}")));
            }
            match Disk.kind(&path) {
                Some(PathKind::Folder) if FileTree::includes(&self.key(&path)) => {
                    return Err(UserError::new(format!("cannot read `{path}`: it is a folder")));
                }
                Some(PathKind::Folder) if !name.starts_with('.') => self.folder(&path, depth + 1)?,
                Some(PathKind::File) => self.found.push((self.key(&path), path)),
                _ => {}
            }
        }
        Ok(())
    }

    /// Path relative to the searched folder, with `/`; relative to its parent if the search starts in `configs`.
    fn key(&self, path: &Utf8Path) -> Utf8PathBuf {
        let inner = path.strip_prefix(self.root).unwrap_or(path);
        let around = Utf8Path::new(self.root.file_name().unwrap_or("")).join(inner);
        let key = if FileTree::includes(&around) && !FileTree::includes(inner) { around } else { inner.to_owned() };
        Utf8PathBuf::from(key.as_str().replace('\\', "/"))
    }
}

/// Reads a file, which messages call `shown`.
pub(super) fn read(path: &Utf8Path, shown: &str) -> Result<Vec<u8>, UserError> {
    val3_files::read(path, FileClass::Program)
        .map_err(|error| UserError::new(format!("cannot read `{shown}`: {error}")))
}
