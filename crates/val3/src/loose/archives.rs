//! Archives in a requested folder.

use camino::{Utf8Path, Utf8PathBuf};
use val3_check::loose::ArchiveContent;
use val3_files::archive_entries;

use crate::paths::has_extension;

/// An archive that was not read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct UnreadArchive {
    /// Absolute path.
    pub(crate) path: Utf8PathBuf,
    /// Reason why it was not read.
    pub(crate) content: ArchiveContent,
}

impl UnreadArchive {
    /// Inspects the archive at `path`; `None` if it contains no VAL 3 files.
    pub(crate) fn of(path: Utf8PathBuf) -> Option<Self> {
        // A path that is not on the disk is inside a requested archive.
        let content = if path.exists() { content(&path)? } else { ArchiveContent::Nested };
        Some(Self { path, content })
    }
}

fn content(path: &Utf8Path) -> Option<ArchiveContent> {
    let entries = match archive_entries(path) {
        Ok(entries) => entries,
        Err(fault) => return Some(ArchiveContent::Unknown(fault.to_string())),
    };
    match (count(&entries, "pjx"), count(&entries, "pgx") + count(&entries, "dtx")) {
        (0, 0) => None,
        (0, _) => Some(ArchiveContent::Parts),
        (projects, _) => Some(ArchiveContent::Projects(projects)),
    }
}

/// Number of entries with the extension.
fn count(entries: &[Utf8PathBuf], extension: &str) -> usize {
    entries.iter().filter(|path| has_extension(path, extension)).count()
}
