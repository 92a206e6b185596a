//! Reading and writing files of the project.

use std::fs;

use anyhow::{Context as _, Result};
use camino::Utf8Path;

/// Reads a text file.
///
/// # Errors
/// The file does not exist, or is not UTF-8.
pub(crate) fn read(path: &Utf8Path) -> Result<String> {
    fs::read_to_string(path).with_context(|| format!("reading {path}"))
}

/// Writes a text file, and creates its folder.
///
/// # Errors
/// The file cannot be written.
pub(crate) fn write(path: &Utf8Path, text: &str) -> Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).with_context(|| format!("creating {folder}"))?;
    }
    fs::write(path, text).with_context(|| format!("writing {path}"))
}
