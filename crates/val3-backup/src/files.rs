//! Files of a backup by path.

use crate::DateTime;

/// A file of a backup.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BackupFile {
    /// Path in the backup, with `/`.
    pub path: String,
    /// Size in bytes; 0 for a file on a controller that was listed and not downloaded.
    pub size: u64,
    /// Time of the last change, if the backup contains it, in the time zone of the backup's origin.
    pub modified: Option<DateTime>,
}

/// A file of a backup that exists but cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnreadFile {
    /// Path in the backup.
    pub path: String,
    /// Reason.
    pub reason: String,
}

/// Files of a backup: in a folder, in an archive, or on a controller. Listing and reading are separate, because reading
/// from a controller is slow.
pub trait BackupFiles {
    /// Returns all files, sorted by path.
    fn files(&self) -> &[BackupFile];

    /// Reads a file.
    ///
    /// # Errors
    /// The reason why the file cannot be read.
    fn read(&self, path: &str) -> Result<Vec<u8>, String>;
}

/// Files in memory, as after unpacking an archive.
#[derive(Debug, Default)]
pub struct MemoryFiles {
    files: Vec<BackupFile>,
    contents: std::collections::BTreeMap<String, Vec<u8>>,
}

impl MemoryFiles {
    /// Creates a backup from paths, contents and times of the last change.
    pub fn new(files: impl IntoIterator<Item = (String, Vec<u8>, Option<DateTime>)>) -> Self {
        let mut all = Self::default();
        for (path, content, modified) in files {
            let size = u64::try_from(content.len()).unwrap_or(u64::MAX);
            all.files.push(BackupFile { path: path.clone(), size, modified });
            all.contents.insert(path, content);
        }
        all.files.sort_by(|one, next| one.path.cmp(&next.path));
        all
    }
}

impl BackupFiles for MemoryFiles {
    fn files(&self) -> &[BackupFile] {
        &self.files
    }

    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        self.contents.get(path).cloned().ok_or_else(|| "it does not exist".to_owned())
    }
}
