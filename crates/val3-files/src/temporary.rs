//! Temporary files next to the files that they replace.
//!
//! The temporary file of `start.pgx` is `.start.pgx.val3-tmp`. Its owner holds a file lock, which the system releases
//! when the process ends. A temporary file without a lock is therefore left over from a killed process. Only the owner
//! of the lock may rename or remove the file.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io;

use camino::{Utf8Path, Utf8PathBuf};

use crate::Unwritable;

/// Suffix of a temporary file.
const SUFFIX: &str = "val3-tmp";

/// Suffix of the backup of a file that is overwritten.
const BACKUP_SUFFIX: &str = "val3-old";

/// Maximum number of attempts to create the file while other processes remove it.
const ATTEMPTS: usize = 8;

/// A temporary file that this process owns. Dropping it removes the file.
#[derive(Debug)]
pub(crate) struct Temporary {
    pub(crate) file: File,
    path: Utf8PathBuf,
    is_renamed: bool,
}

impl Temporary {
    /// Creates the temporary file of `target`, and replaces a leftover of a killed process.
    pub(crate) fn create(target: &Utf8Path, access: Access) -> Result<Self, Unwritable> {
        let path = beside(target, SUFFIX);
        for _ in 0..ATTEMPTS {
            match create_new(&path, access) {
                Ok(file) => {
                    lock(&file)?;
                    // Before the lock was acquired, another process may have removed the file as a leftover.
                    if is_at(&file, &path) {
                        return Ok(Self { file, path, is_renamed: false });
                    }
                }
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => remove_leftover(&path)?,
                Err(error) => return Err(error.into()),
            }
        }
        Err(Unwritable::Busy)
    }

    /// Renames the file to `target`, which is replaced.
    pub(crate) fn rename(mut self, target: &Utf8Path) -> io::Result<()> {
        fs::rename(&self.path, target)?;
        self.is_renamed = true;
        sync_folder(target)
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if !self.is_renamed {
            // If this fails, the next write of the file removes the leftover.
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// Backup path for a file that is overwritten.
pub(crate) fn backup(target: &Utf8Path) -> Utf8PathBuf {
    beside(target, BACKUP_SUFFIX)
}

/// Users that may read a new file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Access {
    /// The users that may read other new files of this user.
    Usual,
    /// Only this user, because the replaced file may be secret.
    Owner,
}

/// Creates a file that does not exist.
#[cfg(unix)]
pub(crate) fn create_new(path: &Utf8Path, access: Access) -> io::Result<File> {
    use std::os::unix::fs::OpenOptionsExt as _;
    let mode = match access {
        Access::Usual => 0o666,
        Access::Owner => 0o600,
    };
    OpenOptions::new().read(true).write(true).create_new(true).mode(mode).open(path)
}

/// Creates a file that does not exist.
#[cfg(not(unix))]
pub(crate) fn create_new(path: &Utf8Path, _: Access) -> io::Result<File> {
    OpenOptions::new().read(true).write(true).create_new(true).open(path)
}

/// Syncs the folder of `path`, so that its file names survive a power failure.
#[cfg(unix)]
pub(crate) fn sync_folder(path: &Utf8Path) -> io::Result<()> {
    match File::open(folder(path)).and_then(|folder| folder.sync_all()) {
        // The file system does not support the operation.
        Err(error) if matches!(error.kind(), io::ErrorKind::InvalidInput | io::ErrorKind::Unsupported) => Ok(()),
        // A folder that is writable but not readable cannot be opened.
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => Ok(()),
        synced => synced,
    }
}

/// Without effect, because the file system itself syncs file names.
#[cfg(not(unix))]
pub(crate) fn sync_folder(_: &Utf8Path) -> io::Result<()> {
    Ok(())
}

#[cfg(unix)]
fn folder(path: &Utf8Path) -> &Utf8Path {
    path.parent().filter(|folder| !folder.as_str().is_empty()).unwrap_or(Utf8Path::new("."))
}

fn beside(target: &Utf8Path, suffix: &str) -> Utf8PathBuf {
    target.with_file_name(format!(".{}.{suffix}", target.file_name().unwrap_or_default()))
}

/// Removes a temporary file that no process owns.
fn remove_leftover(path: &Utf8Path) -> Result<(), Unwritable> {
    let metadata = match fs::symlink_metadata(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        found => found?,
    };
    // The tools create regular files only, and do not touch the target of a link.
    if metadata.is_file() {
        let file = match File::open(path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
            opened => opened?,
        };
        lock(&file)?;
        if !is_at(&file, path) {
            return Ok(());
        }
    }
    match fs::remove_file(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        removed => Ok(removed?),
    }
}

/// Locks a file until it is closed.
pub(crate) fn lock(file: &File) -> Result<(), Unwritable> {
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => Err(Unwritable::Busy),
        // On a file system without locks, leftovers cannot be distinguished from files in use.
        Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => Ok(()),
        Err(TryLockError::Error(error)) => Err(error.into()),
        Ok(()) => Ok(()),
    }
}

/// Whether the path still refers to the open file.
#[cfg(unix)]
fn is_at(file: &File, path: &Utf8Path) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    let identity = |metadata: fs::Metadata| (metadata.dev(), metadata.ino());
    let opened = file.metadata().map(identity).ok();
    opened.is_some() && opened == fs::symlink_metadata(path).map(identity).ok()
}

/// Whether the path still refers to the open file: always, because other processes cannot replace it on this system.
#[cfg(not(unix))]
fn is_at(_: &File, path: &Utf8Path) -> bool {
    path.is_file()
}
