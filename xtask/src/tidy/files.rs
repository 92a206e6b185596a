//! Hand-written texts of the project.

use anyhow::Context;
use camino::{Utf8Path, Utf8PathBuf};

/// Folders with generated files, or with files in another program's format.
const SKIPPED_FOLDERS: &[&str] = &["target", ".git", "node_modules", "examples", "corpus", "artifacts", "snapshots"];

/// Extensions of the checked files.
const EXTENSIONS: &[&str] = &["rs", "md", "toml"];

/// A file with its text.
#[derive(Debug)]
pub(crate) struct TextFile {
    /// Path relative to the project's folder, with `/`.
    pub(crate) path: Utf8PathBuf,
    pub(crate) text: String,
}

impl TextFile {
    /// Whether this is a Rust source file.
    pub(crate) fn is_source(&self) -> bool {
        self.path.extension() == Some("rs")
    }
}

/// Reads every text below `root`, sorted by path.
pub(crate) fn all(root: &Utf8Path) -> anyhow::Result<Vec<TextFile>> {
    let mut paths = Vec::new();
    collect(root, &mut paths)?;
    paths.sort();
    paths.iter().map(|path| read(root, path)).collect()
}

fn collect(folder: &Utf8Path, paths: &mut Vec<Utf8PathBuf>) -> anyhow::Result<()> {
    let entries = folder.read_dir_utf8().with_context(|| format!("cannot list {folder}"))?;
    for entry in entries {
        let entry = entry?;
        let path = entry.path();
        if entry.file_type()?.is_dir() {
            if !SKIPPED_FOLDERS.contains(&entry.file_name()) {
                collect(path, paths)?;
            }
        } else if path.extension().is_some_and(|extension| EXTENSIONS.contains(&extension)) {
            paths.push(path.to_owned());
        }
    }
    Ok(())
}

fn read(root: &Utf8Path, path: &Utf8Path) -> anyhow::Result<TextFile> {
    let text = std::fs::read_to_string(path).with_context(|| format!("cannot read {path}"))?;
    Ok(TextFile { path: path.strip_prefix(root).unwrap_or(path).to_owned(), text })
}
