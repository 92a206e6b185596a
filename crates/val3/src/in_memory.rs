//! Requested archives, whose files are overlaid on the disk.

use std::collections::BTreeSet;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::load::LoadError;
use val3_analysis::paths::normalise;
use val3_analysis::system::{OverlayFs, System};
use val3_files::{is_archive_name, unpack};

use crate::paths::has_extension;

/// Extensions of the cell files that a check reads.
const EXTENSIONS: [&str; 9] = ["pjx", "pgx", "dtx", "cfx", "cf", "xml", "toml", "json", "html"];

/// Overlays the files of the requested archives on the file system. An archive within an archive becomes an empty file.
///
/// # Errors
/// An archive cannot be read.
pub(crate) fn add<S: System>(system: &mut OverlayFs<S>, asked: &[Utf8PathBuf]) -> Result<(), LoadError> {
    let asked: Vec<Utf8PathBuf> = asked.iter().map(|path| normalise(path)).collect();
    let archives: BTreeSet<&Utf8Path> = asked.iter().filter_map(|path| archive_around(path)).collect();
    for archive in archives {
        let mut nested = Vec::new();
        let files = unpack(archive, |path| {
            nested.extend(is_archive_name(path).then(|| path.to_owned()));
            is_of_cell(path)
        });
        let files = files.map_err(|fault| LoadError::Path {
            path: archive.to_owned(),
            reason: format!("the archive cannot be read: {fault}"),
        })?;
        files.into_iter().for_each(|(path, bytes)| system.store(archive.join(path), bytes));
        nested.into_iter().for_each(|path| system.store(archive.join(path), Vec::new()));
    }
    Ok(())
}

/// The archive at the path or above it.
pub(crate) fn archive_around(path: &Utf8Path) -> Option<&Utf8Path> {
    path.ancestors().find(|path| is_archive_name(path) && path.is_file())
}

fn is_of_cell(path: &Utf8Path) -> bool {
    EXTENSIONS.iter().any(|extension| has_extension(path, extension))
}
