//! Pull: the controller's files become the local files, and local changes are kept.

use std::collections::BTreeSet;

use crate::access::ControllerFiles;
use crate::compare::{FileDifference, SideChange};
use crate::error::ControllerError;
use crate::identity::ControllerIdentity;
use crate::observer::TransferObserver;
use crate::path::ControllerPath;
use crate::project::{self, ControllerProject, ProjectState};
use crate::status::ProjectStatus;

/// Folder of downloaded files until all are complete.
const INCOMING: &str = "incoming";

/// Versions of a file that both sides have changed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConflictVersions {
    /// Content at the last pull; empty if both sides have added the file.
    pub base: Vec<u8>,
    /// Local content.
    pub local: Vec<u8>,
    /// Content on the controller.
    pub controller: Vec<u8>,
}

/// Merges the versions of a file that both sides have changed. Returns the local content.
pub type MergeConflict<'a> = dyn FnMut(&ControllerPath, &ConflictVersions) -> Result<Vec<u8>, ControllerError> + 'a;

/// Arguments of a pull.
pub struct PullRequest<'a> {
    /// Address without a password, which is remembered.
    pub address: String,
    /// Identity of the controller.
    pub identity: ControllerIdentity,
    /// Folders on the controller.
    pub folders: Vec<ControllerPath>,
    /// Merge of conflicts; without it, they are an error.
    pub merge: Option<&'a mut MergeConflict<'a>>,
}

/// Result of a pull.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PullResult {
    /// Both sides before the pull.
    pub status: ProjectStatus,
    /// Files that were merged.
    pub merged: Vec<ControllerPath>,
}

/// Downloads the files, and updates local files that have no local change.
///
/// All files are downloaded before the first local file is written. An interrupted pull can be repeated.
///
/// # Errors
/// If a file cannot be read or written, or if both sides have changed a file and conflicts are not merged. In the last
/// case, no local file has changed.
pub fn pull(
    project: &mut ControllerProject,
    files: &mut dyn ControllerFiles,
    mut request: PullRequest<'_>,
    observer: &mut dyn TransferObserver,
) -> Result<PullResult, ControllerError> {
    project::remove_tree(&project.area(INCOMING))?;
    let status = {
        let project = &*project;
        let mut store =
            |path: &ControllerPath, bytes: &[u8]| project::write_copy(&project.stored(INCOMING, path), bytes);
        ProjectStatus::read_with(project, files, &request.folders, observer, &mut store)?
    };
    let merges = merged_contents(project, &status, request.merge.as_deref_mut())?;
    apply(project, &status)?;
    for (path, content) in &merges {
        project::write(&project.local(path), content)?;
    }
    remember(project, &status, request)?;
    project::remove_tree(&project.area(INCOMING))?;
    Ok(PullResult { status, merged: merges.into_iter().map(|(path, _)| path).collect() })
}

/// Merges all conflicts in which both sides have the file.
fn merged_contents(
    project: &ControllerProject,
    status: &ProjectStatus,
    merge: Option<&mut MergeConflict<'_>>,
) -> Result<Vec<(ControllerPath, Vec<u8>)>, ControllerError> {
    let conflicts: Vec<&ControllerPath> = status
        .differences
        .iter()
        .filter(|(_, difference)| matches!(difference, FileDifference::Conflict { .. }))
        .map(|(path, _)| path)
        .collect();
    if conflicts.is_empty() {
        return Ok(Vec::new());
    }
    let Some(merge) = merge else {
        return Err(ControllerError::Conflicts(conflicts.into_iter().cloned().collect()));
    };
    let mut merges = Vec::new();
    for path in conflicts {
        if status.local.contains_key(path) && status.controller.contains_key(path) {
            let versions = ConflictVersions {
                base: project.base_content(path).unwrap_or_default(),
                local: project::read(&project.local(path))?,
                controller: project::read(&project.stored(INCOMING, path))?,
            };
            merges.push((path.clone(), merge(path, &versions)?));
        }
    }
    Ok(merges)
}

/// Copies the controller's changes. A file that one side has removed and the other side has changed is kept.
fn apply(project: &ControllerProject, status: &ProjectStatus) -> Result<(), ControllerError> {
    for (path, difference) in &status.differences {
        match difference {
            FileDifference::Controller(SideChange::Removed) => project::remove(&project.local(path))?,
            FileDifference::Controller(SideChange::Added) => {
                let incoming = project.stored(INCOMING, path);
                project::write_copy(&project.stored("base", path), &project::read(&incoming)?)?;
                project::move_file(&incoming, &project.local(path))?;
            }
            FileDifference::Controller(_) | FileDifference::Conflict { local: SideChange::Removed, .. } => {
                let bytes = project::read(&project.stored(INCOMING, path))?;
                project::write(&project.local(path), &bytes)?;
            }
            FileDifference::Local(_) | FileDifference::Conflict { .. } | FileDifference::Alike(_) => {}
        }
    }
    Ok(())
}

/// Stores the digests and contents for the next comparison.
fn remember(
    project: &mut ControllerProject,
    status: &ProjectStatus,
    request: PullRequest<'_>,
) -> Result<(), ControllerError> {
    let base = project.base();
    let is_pulled = |path: &ControllerPath| request.folders.iter().any(|folder| path.is_in(folder));
    for path in base.keys().filter(|path| is_pulled(path) && !status.controller.contains_key(*path)) {
        project::remove(&project.stored("base", path))?;
    }
    for path in status.controller.keys() {
        let is_stored = base.get(path) == status.controller.get(path) && project.stored("base", path).exists();
        let incoming = project.stored(INCOMING, path);
        // A new file was moved to its place before.
        if !is_stored && incoming.exists() {
            project::move_file(&incoming, &project.stored("base", path))?;
        }
    }
    let mut state = ProjectState::new(request.address, request.identity);
    let known = project.state.as_ref().map(|state| state.folders.clone()).unwrap_or_default();
    state.folders = joined(known.into_iter().chain(request.folders.iter().cloned()));
    state.files = base.into_iter().filter(|(path, _)| !is_pulled(path)).chain(status.controller.clone()).collect();
    project.state = Some(state);
    project.save()
}

/// Folders without those inside others.
fn joined(folders: impl Iterator<Item = ControllerPath>) -> Vec<ControllerPath> {
    let all: BTreeSet<ControllerPath> = folders.collect();
    all.iter().filter(|folder| !all.iter().any(|other| other != *folder && folder.is_in(other))).cloned().collect()
}
