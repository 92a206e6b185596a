//! Push journal, with the old and new contents of changed files: `.val3/backup/TIME`.
//!
//! It is written before the controller is changed, so that the next command can undo a push whose process was killed.

use camino::{Utf8Path, Utf8PathBuf};
use serde::{Deserialize, Serialize};
use val3_files::{FileClass, FolderEntryKind};

use super::plan::PlannedChange;
use crate::digest::FileDigest;
use crate::error::ControllerError;
use crate::path::ControllerPath;
use crate::project::{self, ControllerProject, local};

/// Name of the journal in the folder of the backup.
const JOURNAL: &str = "journal.json";

/// Version of the journal's form.
const VERSION: u32 = 1;

/// Progress of a push.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum PushPhase {
    /// Only temporary files and new folders are written.
    Uploading,
    /// Files get their names, and old files are removed.
    Renaming,
    /// The push is complete or undone.
    Complete,
}

/// Data for undoing or completing a push.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct PushJournal {
    version: u32,
    pub(super) phase: PushPhase,
    /// Serial number of the controller.
    pub(super) serial: String,
    /// Text of the lock.
    pub(super) lock: String,
    /// Folders that the push creates.
    pub(super) new_folders: Vec<ControllerPath>,
    /// Changes in the order in which they become effective.
    pub(super) changes: Vec<PlannedChange>,
}

impl PushJournal {
    pub(super) fn new(
        serial: String,
        lock: String,
        new_folders: Vec<ControllerPath>,
        changes: Vec<PlannedChange>,
    ) -> Self {
        Self { version: VERSION, phase: PushPhase::Uploading, serial, lock, new_folders, changes }
    }
}

/// Folder of a backup.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct BackupFolder(Utf8PathBuf);

impl BackupFolder {
    /// Creates the folder of a new backup. `name` is the time; pushes in the same second are numbered.
    pub(super) fn create(project: &ControllerProject, name: &str) -> Result<Self, ControllerError> {
        let area = project.area("backup");
        val3_files::create_folders(&area).map_err(|reason| local(&area, &reason))?;
        let mut folder = area.join(name);
        for number in 2.. {
            if !folder.exists() {
                break;
            }
            folder = area.join(format!("{name}-{number:03}"));
        }
        val3_files::create_folder(&folder).map_err(|reason| local(&folder, &reason))?;
        Ok(Self(folder))
    }

    /// Returns the backups of pushes that are not complete, the latest first.
    pub(super) fn unfinished(project: &ControllerProject) -> Result<Vec<(Self, PushJournal)>, ControllerError> {
        let area = project.area("backup");
        if !area.is_dir() {
            return Ok(Vec::new());
        }
        let entries = val3_files::list_folder(&area).map_err(|reason| local(&area, &reason))?;
        let mut unfinished = Vec::new();
        for entry in entries.iter().rev().filter(|entry| entry.kind == FolderEntryKind::Folder) {
            let folder = Self(area.join(&entry.name));
            if let Some(journal) = folder.read()?
                && journal.phase != PushPhase::Complete
            {
                unfinished.push((folder, journal));
            }
        }
        Ok(unfinished)
    }

    /// Path of the folder, for messages.
    pub(super) fn path(&self) -> &Utf8Path {
        &self.0
    }

    /// Reads the journal; `None` if the push ended before it was written, when the controller was unchanged.
    fn read(&self) -> Result<Option<PushJournal>, ControllerError> {
        let path = self.0.join(JOURNAL);
        if !path.try_exists().map_err(|error| local(&path, &error))? {
            return Ok(None);
        }
        let text = val3_files::read_text(&path, FileClass::Record).map_err(|reason| local(&path, &reason))?;
        let journal: PushJournal = serde_json::from_str(&text).map_err(|error| local(&path, &error))?;
        if journal.version != VERSION {
            return Err(local(&path, &"it was written by another version of val3"));
        }
        Ok(Some(journal))
    }

    /// Writes the journal, and waits until the disk has it.
    pub(super) fn write(&self, journal: &PushJournal) -> Result<(), ControllerError> {
        let path = self.0.join(JOURNAL);
        let text = serde_json::to_string_pretty(journal).map_err(|error| local(&path, &error))?;
        project::write(&path, format!("{text}\n").as_bytes())
    }

    /// Writes the journal of a push that needs no recovery, and removes the copies of the new contents.
    pub(super) fn complete(&self, mut journal: PushJournal) -> Result<(), ControllerError> {
        journal.phase = PushPhase::Complete;
        self.write(&journal)?;
        project::remove_tree(&self.0.join("new"))
    }

    /// Stores a content of the controller before the push.
    pub(super) fn store_old(&self, path: &ControllerPath, bytes: &[u8]) -> Result<(), ControllerError> {
        project::write(&self.0.join("old").join(path.as_str()), bytes)
    }

    /// Stores a content that the push uploads.
    pub(super) fn store_new(&self, path: &ControllerPath, bytes: &[u8]) -> Result<(), ControllerError> {
        project::write(&self.0.join("new").join(path.as_str()), bytes)
    }

    /// Content of the controller before the push.
    pub(super) fn old(&self, path: &ControllerPath, digest: &FileDigest) -> Result<Vec<u8>, ControllerError> {
        self.content("old", path, digest)
    }

    /// Content that the push uploads.
    pub(super) fn new_content(&self, path: &ControllerPath, digest: &FileDigest) -> Result<Vec<u8>, ControllerError> {
        self.content("new", path, digest)
    }

    fn content(&self, area: &str, path: &ControllerPath, digest: &FileDigest) -> Result<Vec<u8>, ControllerError> {
        let at = self.0.join(area).join(path.as_str());
        let bytes = project::read(&at)?;
        if FileDigest::of(&bytes) == *digest { Ok(bytes) } else { Err(local(&at, &"this backup was changed")) }
    }
}
