//! Steps for single files and folders, shared by push and recovery.

use std::collections::BTreeSet;

use super::plan::{PlannedChange, PushPlan};
use crate::access::{AccessError, AccessFault, ControllerFiles};
use crate::digest::FileDigest;
use crate::error::ControllerError;
use crate::path::ControllerPath;
use crate::scan::Presence;

/// Folders of the uploads that do not exist, the outer ones first.
pub(super) fn new_folders(
    files: &mut dyn ControllerFiles,
    plan: &PushPlan,
) -> Result<Vec<ControllerPath>, ControllerError> {
    let mut presence = Presence::default();
    let mut folders = BTreeSet::new();
    for change in plan.uploads() {
        for folder in std::iter::successors(change.path.parent(), ControllerPath::parent) {
            if presence.has(files, &folder)? {
                break;
            }
            folders.insert(folder);
        }
    }
    Ok(folders.into_iter().collect())
}

/// Limit for reading a file that has its old or new content.
pub(super) fn limit(change: &PlannedChange) -> u64 {
    let sizes = [&change.old, &change.new].into_iter().flatten().map(|digest| digest.size);
    // A file with another content is longer than expected at most by one byte.
    sizes.max().unwrap_or(0).saturating_add(1)
}

/// Reads a file, and checks that it has the old content.
pub(super) fn read_expected(
    files: &mut dyn ControllerFiles,
    change: &PlannedChange,
    digest: &FileDigest,
) -> Result<Vec<u8>, ControllerError> {
    let bytes = match files.read(&change.path, digest.size) {
        Err(AccessError { reason: AccessFault::TooLarge(_), .. }) => {
            return Err(ControllerError::ChangedMeanwhile(change.path.clone()));
        }
        bytes => bytes?,
    };
    if FileDigest::of(&bytes) == *digest {
        Ok(bytes)
    } else {
        Err(ControllerError::ChangedMeanwhile(change.path.clone()))
    }
}

/// Writes a file under its temporary name, and reads it back.
pub(super) fn upload(
    files: &mut dyn ControllerFiles,
    path: &ControllerPath,
    bytes: &[u8],
) -> Result<(), ControllerError> {
    let temporary = path.temporary();
    files.write(&temporary, bytes)?;
    let read = files.read(&temporary, bytes.len() as u64 + 1)?;
    if read == bytes { Ok(()) } else { Err(ControllerError::NotAsWritten(temporary)) }
}

/// Renames a file over an existing one. A controller that rejects this needs the old file removed first.
pub(super) fn replace(
    files: &mut dyn ControllerFiles,
    from: &ControllerPath,
    to: &ControllerPath,
) -> Result<(), AccessError> {
    match files.rename(from, to) {
        Err(error) if error.is_rejection() => {
            files.remove(to).map_err(|_| error)?;
            files.rename(from, to)
        }
        renamed => renamed,
    }
}

/// Removes the folders of removed files that are empty, up to the folder of the applications.
pub(super) fn remove_empty_folders<'p>(
    files: &mut dyn ControllerFiles,
    removed: impl Iterator<Item = &'p ControllerPath>,
) -> Result<(), AccessError> {
    let folders: BTreeSet<ControllerPath> = removed
        .flat_map(|path| std::iter::successors(path.parent(), ControllerPath::parent))
        .filter(|folder| folder.is_in(&ControllerPath::applications()) && *folder != ControllerPath::applications())
        .collect();
    for folder in folders.iter().rev() {
        if files.list(folder)?.is_empty() {
            files.remove_folder(folder)?;
        }
    }
    Ok(())
}
