//! Recovery of a push that has failed, or whose process was killed.

use super::file_steps::{limit, replace, upload};
use super::journal::{BackupFolder, PushJournal, PushPhase};
use super::lock;
use super::plan::PlannedChange;
use crate::access::{AccessError, AccessFault, ControllerFiles};
use crate::digest::FileDigest;
use crate::error::ControllerError;
use crate::identity::ControllerIdentity;
use crate::observer::{TransferObserver, TransferStep};
use crate::path::ControllerPath;
use crate::project::{self, ControllerProject};
use crate::running;
use crate::scan::Presence;

/// Result of a recovery.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RecoveryOutcome {
    /// Only temporary files existed, and were removed. The applications have their old files.
    Cancelled,
    /// All new files were in place. The push is complete.
    Completed,
    /// The old files were restored.
    Restored {
        /// Number of files that were restored.
        count: usize,
        /// Files that another client has changed meanwhile, and that were kept.
        kept: Vec<ControllerPath>,
    },
}

/// A push whose process has ended before its end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecoveredPush {
    /// Folder of the backup.
    pub backup: String,
    /// Result.
    pub outcome: RecoveryOutcome,
}

/// Recovers all pushes of the project that are not complete. `now` is in seconds since 1970.
///
/// # Errors
/// If a push has changed another controller, another push is running, here or elsewhere, a backup cannot be read, or
/// the controller cannot be changed. The recovery can be repeated.
pub fn recover(
    project: &mut ControllerProject,
    files: &mut dyn ControllerFiles,
    identity: &ControllerIdentity,
    now: u64,
    observer: &mut dyn TransferObserver,
) -> Result<Vec<RecoveredPush>, ControllerError> {
    let mut recovered = Vec::new();
    if BackupFolder::unfinished(project)?.is_empty() {
        return Ok(recovered);
    }
    let _running = running::lock(project)?;
    // A push that was running meanwhile has completed its journal.
    for (backup, journal) in BackupFolder::unfinished(project)? {
        if journal.serial != identity.serial {
            let backup = backup.path().to_string();
            return Err(ControllerError::UnfinishedElsewhere { serial: journal.serial, backup });
        }
        lock::check_free(files, &journal.lock, now)?;
        let outcome = undo(project, &backup, &journal, files, observer)?;
        recovered.push(RecoveredPush { backup: backup.path().to_string(), outcome });
    }
    Ok(recovered)
}

/// Removes the traces of a push, and restores files unless all new files are in place.
pub(super) fn undo(
    project: &mut ControllerProject,
    backup: &BackupFolder,
    journal: &PushJournal,
    files: &mut dyn ControllerFiles,
    observer: &mut dyn TransferObserver,
) -> Result<RecoveryOutcome, ControllerError> {
    let outcome = match journal.phase {
        PushPhase::Uploading | PushPhase::Complete => RecoveryOutcome::Cancelled,
        PushPhase::Renaming => restore(backup, journal, files, observer)?,
    };
    remove_temporary(journal, files)?;
    if outcome == RecoveryOutcome::Completed {
        remember(project, backup, journal)?;
    } else {
        remove_new_folders(journal, files)?;
    }
    lock::release(files, &journal.lock)?;
    backup.complete(journal.clone())?;
    Ok(outcome)
}

/// Records a complete push, and removes the lock.
pub(super) fn finish(
    project: &mut ControllerProject,
    backup: &BackupFolder,
    journal: &PushJournal,
    files: &mut dyn ControllerFiles,
) -> Result<(), ControllerError> {
    remember(project, backup, journal)?;
    lock::release(files, &journal.lock)?;
    backup.complete(journal.clone())
}

/// Stores the new contents as the state of the last push.
fn remember(
    project: &mut ControllerProject,
    backup: &BackupFolder,
    journal: &PushJournal,
) -> Result<(), ControllerError> {
    for change in &journal.changes {
        let stored = project.stored("base", &change.path);
        match &change.new {
            Some(digest) => project::write(&stored, &backup.new_content(&change.path, digest)?)?,
            None => project::remove(&stored)?,
        }
        if let Some(state) = &mut project.state {
            match &change.new {
                Some(digest) => _ = state.files.insert(change.path.clone(), digest.clone()),
                None => _ = state.files.remove(&change.path),
            }
        }
    }
    project.save()
}

/// Content of a file compared with a change.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Found {
    Old,
    New,
    /// The file does not exist, but has an old and a new content: it was removed before the rename.
    Missing,
    /// Neither content.
    Other,
}

fn restore(
    backup: &BackupFolder,
    journal: &PushJournal,
    files: &mut dyn ControllerFiles,
    observer: &mut dyn TransferObserver,
) -> Result<RecoveryOutcome, ControllerError> {
    let mut presence = Presence::default();
    let mut found = Vec::new();
    for change in &journal.changes {
        found.push((change, state_of(change, files, &mut presence)?));
    }
    if found.iter().all(|(_, found)| *found == Found::New) {
        return Ok(RecoveryOutcome::Completed);
    }
    let changed: Vec<_> = found.iter().filter(|(_, found)| matches!(found, Found::New | Found::Missing)).collect();
    observer.step(TransferStep::Restore, changed.len());
    for (change, _) in &changed {
        restore_file(change, backup, files)?;
        observer.file(&change.path, change.old.as_ref().map_or(0, |digest| digest.size));
    }
    let kept: Vec<ControllerPath> =
        found.iter().filter(|(_, found)| *found == Found::Other).map(|(change, _)| change.path.clone()).collect();
    if changed.is_empty() && kept.is_empty() {
        return Ok(RecoveryOutcome::Cancelled);
    }
    Ok(RecoveryOutcome::Restored { count: changed.len(), kept })
}

fn state_of(
    change: &PlannedChange,
    files: &mut dyn ControllerFiles,
    presence: &mut Presence,
) -> Result<Found, ControllerError> {
    if !presence.has(files, &change.path)? {
        return Ok(match (&change.old, &change.new) {
            (_, None) => Found::New,
            (None, _) => Found::Old,
            (Some(_), Some(_)) => Found::Missing,
        });
    }
    let bytes = match files.read(&change.path, limit(change)) {
        Err(AccessError { reason: AccessFault::TooLarge(_), .. }) => return Ok(Found::Other),
        bytes => bytes?,
    };
    let digest = Some(FileDigest::of(&bytes));
    Ok(match digest {
        digest if digest == change.old => Found::Old,
        digest if digest == change.new => Found::New,
        _ => Found::Other,
    })
}

/// Writes the old content, and reads it back.
fn restore_file(
    change: &PlannedChange,
    backup: &BackupFolder,
    files: &mut dyn ControllerFiles,
) -> Result<(), ControllerError> {
    let Some(digest) = &change.old else { return Ok(files.remove(&change.path)?) };
    make_folders(files, &change.path)?;
    let bytes = backup.old(&change.path, digest)?;
    upload(files, &change.path, &bytes)?;
    replace_or_add(files, &change.path)?;
    let read = files.read(&change.path, digest.size.saturating_add(1))?;
    if read == bytes { Ok(()) } else { Err(ControllerError::NotAsWritten(change.path.clone())) }
}

/// Renames the temporary file, whether its new name exists or not.
fn replace_or_add(files: &mut dyn ControllerFiles, path: &ControllerPath) -> Result<(), ControllerError> {
    match Presence::default().has(files, path)? {
        true => Ok(replace(files, &path.temporary(), path)?),
        false => Ok(files.rename(&path.temporary(), path)?),
    }
}

/// Creates the folders above a file that the push has removed.
fn make_folders(files: &mut dyn ControllerFiles, path: &ControllerPath) -> Result<(), ControllerError> {
    let mut folders: Vec<ControllerPath> = std::iter::successors(path.parent(), ControllerPath::parent).collect();
    folders.reverse();
    let mut presence = Presence::default();
    for folder in folders {
        if !presence.has(files, &folder)? {
            files.make_folder(&folder)?;
            presence = Presence::default();
        }
    }
    Ok(())
}

fn remove_temporary(journal: &PushJournal, files: &mut dyn ControllerFiles) -> Result<(), ControllerError> {
    let mut presence = Presence::default();
    for change in &journal.changes {
        let temporary = change.path.temporary();
        if presence.has(files, &temporary)? {
            files.remove(&temporary)?;
        }
    }
    Ok(())
}

/// Removes the folders that the push has created, unless another client has put files there.
fn remove_new_folders(journal: &PushJournal, files: &mut dyn ControllerFiles) -> Result<(), ControllerError> {
    for folder in journal.new_folders.iter().rev() {
        if Presence::default().has(files, folder)? && files.list(folder)?.is_empty() {
            files.remove_folder(folder)?;
        }
    }
    Ok(())
}
