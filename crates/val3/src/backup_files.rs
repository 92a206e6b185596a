//! Backups on the disk, which are folders and ZIP archives, and controllers at an address.

mod address;

use std::collections::BTreeSet;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::load::refused_link;
use val3_analysis::system::{Disk, PathKind, System as _};
use val3_backup::{BackupFile, BackupFiles, DateTime, MemoryFiles};
use val3_files::{FileClass, archive_dates, is_archive_name, unpack};

use crate::paths::is_address;
use crate::user_error::UserError;

pub(crate) use address::{RemoteFolders, open_address};

/// Maximum depth of searched folders.
const DEPTH: usize = 32;

/// Maximum number of files.
const MOST_FILES: usize = 100_000;

/// An opened backup or controller.
pub(crate) struct OpenedBackup {
    /// Files of the backup.
    pub(crate) files: Box<dyn BackupFiles>,
    /// Absolute path of the folder or archive, or the address.
    pub(crate) root: Utf8PathBuf,
    /// Paths of folders and links that were not searched, with the reason.
    pub(crate) unread: Vec<(Utf8PathBuf, String)>,
    /// Paths of files that a controller did not send, with the reason. Their sizes are unknown.
    pub(crate) denied: Vec<(Utf8PathBuf, String)>,
}

impl OpenedBackup {
    /// Whether the files are on a controller instead of on the disk.
    pub(crate) fn is_remote(&self) -> bool {
        is_address(&self.root)
    }
}

/// Opens the folder or archive at an absolute path.
///
/// # Errors
/// It cannot be read, or contains more files than a backup.
pub(crate) fn open(root: &Utf8Path) -> Result<OpenedBackup, UserError> {
    if root.is_dir() {
        return folder(root);
    }
    if !root.exists() {
        return Err(UserError::new(format!("`{root}` does not exist")));
    }
    if !is_archive_name(root) {
        let message = format!("`{root}` is neither a folder nor a zip");
        return Err(UserError::new(message).with_help("name the folder or the zip of a backup"));
    }
    let fault = |fault| UserError::new(format!("cannot read the archive `{root}`: {fault}"));
    let dates: std::collections::BTreeMap<_, _> = archive_dates(root).map_err(fault)?.into_iter().collect();
    let files = unpack(root, |_| true).map_err(fault)?;
    let files = files.into_iter().map(|(path, bytes)| {
        let date = dates.get(&path).and_then(|[year, month, day, hour, minute, second]| {
            DateTime::parse(&format!("{year}-{month}-{day}T{hour}:{minute}:{second}"))
        });
        (path.into_string(), bytes, date)
    });
    let files = Box::new(MemoryFiles::new(files));
    Ok(OpenedBackup { files, root: root.to_owned(), unread: Vec::new(), denied: Vec::new() })
}

fn folder(root: &Utf8Path) -> Result<OpenedBackup, UserError> {
    let mut search = FolderSearch { root, files: Vec::new(), seen: BTreeSet::new(), unread: Vec::new() };
    search.folder(root, 0)?;
    let FolderSearch { mut files, unread, .. } = search;
    files.sort_by(|one, next| one.path.cmp(&next.path));
    let files = Box::new(FolderFiles { root: root.to_owned(), files });
    Ok(OpenedBackup { files, root: root.to_owned(), unread, denied: Vec::new() })
}

/// Files in a folder.
struct FolderFiles {
    root: Utf8PathBuf,
    files: Vec<BackupFile>,
}

impl BackupFiles for FolderFiles {
    fn files(&self) -> &[BackupFile] {
        &self.files
    }

    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        val3_files::read(&self.root.join(path), FileClass::Record).map_err(|reason| reason.to_string())
    }
}

struct FolderSearch<'r> {
    root: &'r Utf8Path,
    files: Vec<BackupFile>,
    /// Folders already searched, so that circular links end.
    seen: BTreeSet<Utf8PathBuf>,
    unread: Vec<(Utf8PathBuf, String)>,
}

impl FolderSearch<'_> {
    fn folder(&mut self, folder: &Utf8Path, depth: usize) -> Result<(), UserError> {
        if !self.seen.insert(Disk.identity(folder)) {
            return Ok(());
        }
        if depth > DEPTH {
            self.unread.push((folder.to_owned(), format!("it lies more than {DEPTH} folders deep")));
            return Ok(());
        }
        let names = match Disk.list(folder) {
            Ok(names) => names,
            Err(error) => {
                self.unread.push((folder.to_owned(), error.to_string()));
                return Ok(());
            }
        };
        // Files and folders whose names begin with a dot belong to other tools.
        for name in names.iter().filter(|name| !name.starts_with('.')) {
            self.entry(&folder.join(name), depth)?;
        }
        Ok(())
    }

    fn entry(&mut self, path: &Utf8Path, depth: usize) -> Result<(), UserError> {
        if let Some(reason) = refused_link(&Disk, self.root, path) {
            self.unread.push((path.to_owned(), reason));
            return Ok(());
        }
        match Disk.kind(path) {
            Some(PathKind::Folder) => self.folder(path, depth + 1),
            Some(PathKind::File) => {
                let inner = path.strip_prefix(self.root).unwrap_or(path).as_str().replace('\\', "/");
                self.files.push(BackupFile { path: inner, size: Disk.size(path), modified: modified(path) });
                self.check_count()
            }
            None => Ok(()),
        }
    }

    fn check_count(&self) -> Result<(), UserError> {
        if self.files.len() <= MOST_FILES {
            return Ok(());
        }
        let message = format!("`{}` contains more than {MOST_FILES} files, which is no backup", self.root);
        Err(UserError::new(message).with_help("name the folder of a controller"))
    }
}

/// Time of the last change, in UTC.
fn modified(path: &Utf8Path) -> Option<DateTime> {
    let time = path.metadata().ok()?.modified().ok()?.duration_since(std::time::UNIX_EPOCH).ok()?;
    DateTime::from_unix(time.as_secs().try_into().ok()?)
}
