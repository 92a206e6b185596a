//! Writes files of `val3 arm`; existing files are replaced only with `--force`.

use std::fs;

use camino::Utf8Path;
use val3_files::replace;

use crate::user_error::UserError;

/// Writes a text file.
pub(super) fn write_file(path: &Utf8Path, text: &str) -> Result<(), UserError> {
    replace(path, text.as_bytes()).map_err(|reason| {
        UserError::new(format!("cannot write `{path}`: {reason}"))
            .with_help("name a file in an existing folder that you may write to")
    })
}

/// Checks that no file exists at `path`.
pub(super) fn check_absent(path: &Utf8Path) -> Result<(), UserError> {
    // Not `exists`, which returns false for a dangling link.
    if fs::symlink_metadata(path).is_err() {
        return Ok(());
    }
    Err(UserError::new(format!("`{path}` exists")).with_help("--force replaces it"))
}
