//! Execution of a push.

use super::file_steps::{limit, new_folders, read_expected, remove_empty_folders, replace, upload};
use super::journal::{BackupFolder, PushJournal, PushPhase};
use super::lock::{self, LockOwner};
use super::plan::PushPlan;
use super::recovery::{RecoveryOutcome, finish, undo};
use crate::access::ControllerFiles;
use crate::digest::FileDigest;
use crate::error::ControllerError;
use crate::observer::{TransferObserver, TransferStep, check_interrupt};
use crate::project::{self, ControllerProject};
use crate::running;
use crate::scan::Presence;

/// Arguments of a push.
#[derive(Clone, Copy)]
pub struct PushRequest<'a> {
    /// Changes.
    pub plan: &'a PushPlan,
    /// Owner of the lock.
    pub owner: &'a LockOwner,
    /// Time in seconds since 1970.
    pub now: u64,
    /// Name of the backup's folder, for example `2026-11-29T11-00-00Z`.
    pub backup: &'a str,
}

/// Failed push.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PushFailure {
    /// The cause.
    pub error: ControllerError,
    /// State of the controller.
    pub outcome: FailureOutcome,
}

/// State of the controller after a failed push.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FailureOutcome {
    /// No application was changed, and nothing remains of the push.
    Unchanged,
    /// Files were changed, and have their old contents again.
    Restored(RecoveryOutcome),
    /// The push could not be undone. The next command tries it again.
    Unfinished {
        /// Reason why it could not be undone.
        error: ControllerError,
        /// Whether files of the applications may have changed.
        may_have_changed: bool,
        /// Folder of the backup.
        backup: String,
    },
}

/// Uploads the changes.
///
/// Until the last uploaded file is verified, applications keep their files. Then all files are renamed in one pass,
/// during which interruptions are ignored.
///
/// # Errors
/// If a step fails. The push is then undone, if the controller can still be reached.
#[allow(clippy::result_large_err, reason = "there is one result for each push")]
pub fn push(
    project: &mut ControllerProject,
    files: &mut dyn ControllerFiles,
    request: PushRequest<'_>,
    observer: &mut dyn TransferObserver,
) -> Result<(), PushFailure> {
    let untouched = |error| PushFailure { error, outcome: FailureOutcome::Unchanged };
    let _running = running::lock(project).map_err(untouched)?;
    let mut push = RunningPush::prepare(project, files, request).map_err(untouched)?;
    let result = push.execute(files, request.now, observer);
    match result.and_then(|()| finish(project, &push.backup, &push.journal, files)) {
        Ok(()) => Ok(()),
        Err(error) => Err(push.fail(project, files, error, observer)),
    }
}

/// A push with its journal.
struct RunningPush {
    backup: BackupFolder,
    journal: PushJournal,
    /// Whether another push has held the lock from the start, so that nothing was written.
    was_locked: bool,
}

impl RunningPush {
    /// Copies the new contents, and writes the journal. The controller is not changed.
    fn prepare(
        project: &ControllerProject,
        files: &mut dyn ControllerFiles,
        request: PushRequest<'_>,
    ) -> Result<Self, ControllerError> {
        let new_folders = new_folders(files, request.plan)?;
        let backup = BackupFolder::create(project, request.backup)?;
        for change in request.plan.uploads() {
            let bytes = project::read(&project.local(&change.path))?;
            if Some(FileDigest::of(&bytes)) != change.new {
                return Err(ControllerError::LocalChanged(change.path.clone()));
            }
            backup.store_new(&change.path, &bytes)?;
        }
        let serial = project.state.as_ref().map(|state| state.controller.serial.clone()).unwrap_or_default();
        let lock = lock::text(request.owner, request.now);
        let journal = PushJournal::new(serial, lock, new_folders, request.plan.changes.clone());
        backup.write(&journal)?;
        Ok(Self { backup, journal, was_locked: false })
    }

    fn execute(
        &mut self,
        files: &mut dyn ControllerFiles,
        now: u64,
        observer: &mut dyn TransferObserver,
    ) -> Result<(), ControllerError> {
        check_interrupt(observer)?;
        let locked = lock::acquire(files, &self.journal.lock, now);
        self.was_locked = matches!(locked, Err(ControllerError::Locked { .. }));
        locked?;
        self.back_up(files, observer)?;
        self.upload(files, observer)?;
        self.check_unchanged(files)?;
        lock::check(files, &self.journal.lock)?;
        check_interrupt(observer)?;
        self.journal.phase = PushPhase::Renaming;
        self.backup.write(&self.journal)?;
        self.rename(files, observer)?;
        self.verify(files, observer)
    }

    /// Downloads each file that changes, and checks that it is the file of the plan.
    fn back_up(
        &self,
        files: &mut dyn ControllerFiles,
        observer: &mut dyn TransferObserver,
    ) -> Result<(), ControllerError> {
        let old: Vec<_> =
            self.journal.changes.iter().filter_map(|change| Some((change, change.old.as_ref()?))).collect();
        observer.step(TransferStep::BackUp, old.len());
        for (change, digest) in old {
            check_interrupt(observer)?;
            let bytes = read_expected(files, change, digest)?;
            self.backup.store_old(&change.path, &bytes)?;
            observer.file(&change.path, digest.size);
        }
        Ok(())
    }

    /// Uploads each file under its temporary name, and reads it back.
    fn upload(
        &self,
        files: &mut dyn ControllerFiles,
        observer: &mut dyn TransferObserver,
    ) -> Result<(), ControllerError> {
        let uploads: Vec<_> =
            self.journal.changes.iter().filter_map(|change| Some((change, change.new.as_ref()?))).collect();
        observer.step(TransferStep::Upload, uploads.len());
        for folder in &self.journal.new_folders {
            files.make_folder(folder)?;
        }
        for (change, digest) in uploads {
            check_interrupt(observer)?;
            let bytes = self.backup.new_content(&change.path, digest)?;
            upload(files, &change.path, &bytes)?;
            observer.file(&change.path, digest.size);
        }
        Ok(())
    }

    /// Reads the files that change once more, immediately before the first of them is replaced.
    fn check_unchanged(&self, files: &mut dyn ControllerFiles) -> Result<(), ControllerError> {
        let mut presence = Presence::default();
        for change in &self.journal.changes {
            match &change.old {
                Some(digest) => _ = read_expected(files, change, digest)?,
                None if presence.has(files, &change.path)? => {
                    return Err(ControllerError::ChangedMeanwhile(change.path.clone()));
                }
                None => {}
            }
        }
        Ok(())
    }

    /// Gives all files their names, then removes files and empty folders.
    fn rename(
        &self,
        files: &mut dyn ControllerFiles,
        observer: &mut dyn TransferObserver,
    ) -> Result<(), ControllerError> {
        observer.step(TransferStep::Rename, self.journal.changes.len());
        for change in &self.journal.changes {
            match change.new {
                Some(_) => replace(files, &change.path.temporary(), &change.path)?,
                None => files.remove(&change.path)?,
            }
            observer.file(&change.path, 0);
        }
        let removed = self.journal.changes.iter().filter(|change| change.new.is_none());
        Ok(remove_empty_folders(files, removed.map(|change| &change.path))?)
    }

    /// Reads each changed file again.
    fn verify(
        &self,
        files: &mut dyn ControllerFiles,
        observer: &mut dyn TransferObserver,
    ) -> Result<(), ControllerError> {
        observer.step(TransferStep::Verify, self.journal.changes.len());
        let mut presence = Presence::default();
        for change in &self.journal.changes {
            let is_present = presence.has(files, &change.path)?;
            let found = match is_present {
                true => Some(FileDigest::of(&files.read(&change.path, limit(change))?)),
                false => None,
            };
            if found != change.new {
                return Err(ControllerError::NotAsWritten(change.path.clone()));
            }
            observer.file(&change.path, found.map_or(0, |digest| digest.size));
        }
        Ok(())
    }

    /// Undoes the push after a failure.
    fn fail(
        self,
        project: &mut ControllerProject,
        files: &mut dyn ControllerFiles,
        error: ControllerError,
        observer: &mut dyn TransferObserver,
    ) -> PushFailure {
        if matches!(error, ControllerError::Locked { .. }) {
            // The temporary files may belong to the other push.
            let outcome = match self.was_locked {
                true => match self.backup.complete(self.journal.clone()) {
                    Ok(()) => FailureOutcome::Unchanged,
                    Err(error) => self.unfinished(error),
                },
                false => self.unfinished(error.clone()),
            };
            return PushFailure { error, outcome };
        }
        let undone = undo(project, &self.backup, &self.journal, files, observer);
        // The connection may be the cause of the failure.
        let undone = undone.or_else(|_| {
            files.reconnect()?;
            undo(project, &self.backup, &self.journal, files, observer)
        });
        let outcome = match undone {
            Ok(outcome) if self.may_have_changed() => FailureOutcome::Restored(outcome),
            Ok(_) => FailureOutcome::Unchanged,
            Err(error) => self.unfinished(error),
        };
        PushFailure { error, outcome }
    }

    /// Outcome of a push that cannot be undone because of `error`.
    fn unfinished(&self, error: ControllerError) -> FailureOutcome {
        let backup = self.backup.path().to_string();
        FailureOutcome::Unfinished { error, may_have_changed: self.may_have_changed(), backup }
    }

    /// Whether files on the controller may have been replaced.
    fn may_have_changed(&self) -> bool {
        self.journal.phase == PushPhase::Renaming
    }
}
