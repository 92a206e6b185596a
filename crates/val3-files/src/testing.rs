//! Test support: a temporary folder.

use camino::Utf8PathBuf;
use tempfile::TempDir;

/// A folder and its path. It is deleted when the first value is dropped.
pub(crate) fn folder() -> (TempDir, Utf8PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = Utf8PathBuf::from_path_buf(folder.path().to_owned()).unwrap();
    (folder, path)
}
