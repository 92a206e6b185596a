//! The disk, overlaid with the texts of open documents.

use std::sync::Arc;

use camino::Utf8PathBuf;
use val3_analysis::system::{Disk, OverlayFs};

use crate::detached;
use crate::documents::Documents;
use crate::snapshot::Snapshot;

/// Files for the loader: open documents and the project files of detached documents hide stored files.
pub(crate) fn files(documents: &Documents, detached: &[Utf8PathBuf]) -> OverlayFs<Disk> {
    let mut files = OverlayFs::new(Disk);
    documents.effective().for_each(|document| files.edit(&document.path, Arc::clone(&document.text)));
    detached.iter().for_each(|path| files.edit(&detached::manifest_path(path), detached::manifest(path).into()));
    files
}

/// Files of a snapshot.
pub(crate) fn files_of(snapshot: &Snapshot) -> OverlayFs<Disk> {
    let mut files = files(&snapshot.documents, &[]);
    for project in snapshot.projects.iter().map(|project| project.manifest(&snapshot.db)) {
        if !snapshot.is_shown(project) {
            files.edit(project.path(&snapshot.db), Arc::clone(project.text(&snapshot.db)));
        }
    }
    files
}
