//! Pull: the controller's files become the local files, and local changes are kept.

mod apply;
mod obstacles;
mod plan;
mod removals;
mod request;

use std::collections::BTreeSet;

use crate::access::ControllerFiles;
use crate::error::ControllerError;
use crate::observer::TransferObserver;
use crate::path::ControllerPath;
use crate::project::{self, BASE, ControllerProject, INCOMING, ProjectState};
use crate::running;
use crate::scan::application_names;
use crate::status::ProjectStatus;

use self::plan::PullPlan;

pub use self::request::{ConflictVersions, MergeConflict, PullDecisions, PullRequest};

/// Result of a pull.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PullResult {
    /// Both sides before the pull.
    pub status: ProjectStatus,
    /// Local files that have the controller's version now.
    pub updated: Vec<ControllerPath>,
    /// Local files that were removed, because the controller no longer has them.
    pub removed: Vec<ControllerPath>,
    /// Local files with the changes of both sides.
    pub merged: Vec<ControllerPath>,
    /// Files that cannot be merged. Both versions are unchanged, and the conflict remains.
    pub unmerged: Vec<ControllerPath>,
    /// Files that were changed here during the pull. The local file is kept, and is a conflict now.
    pub changed_meanwhile: Vec<ControllerPath>,
}

/// Downloads the files, and updates local files that have no local change.
///
/// All files are downloaded before the first local file is written. An interrupted pull can be repeated.
///
/// # Errors
/// If a file cannot be read or written, if both sides have changed a file and conflicts are neither decided nor merged, if
/// a requested application or the files of a whole folder are missing on the controller, if a file is where a folder is
/// needed, or if another process executes a pull or push of the project. In all cases but the first, no local file has
/// changed.
pub fn pull(
    project: &mut ControllerProject,
    files: &mut dyn ControllerFiles,
    mut request: PullRequest<'_>,
    observer: &mut dyn TransferObserver,
) -> Result<PullResult, ControllerError> {
    let _running = running::lock(project)?;
    project::remove_tree(&project.area(INCOMING))?;
    let status = {
        let project = &*project;
        let mut store = |path: &ControllerPath, bytes: &[u8]| write_incoming(project, path, bytes);
        ProjectStatus::read_with(project, files, &request.folders, observer, &mut store)?
    };
    check_applications_exist(project, files, &request.folders, &status)?;
    let plan = PullPlan::new(project, &status, &request.decisions, request.merge.as_deref_mut())?;
    if !request.accepts_removals {
        removals::check(&plan, &status, &request.folders)?;
    }
    obstacles::check(project, &plan)?;
    remove_old_base(project, &status, &request.folders)?;
    let changed_meanwhile = apply::apply(project, &status, &plan)?;
    let is_done = |path: &&ControllerPath| !changed_meanwhile.contains(*path);
    let done = |paths: &[ControllerPath]| paths.iter().filter(is_done).cloned().collect::<Vec<_>>();
    let merged: Vec<ControllerPath> = plan.merges.iter().map(|(path, _)| path.clone()).collect();
    let (updated, removed, merged) = (done(&plan.updates), done(&plan.removals), done(&merged));
    let open: BTreeSet<&ControllerPath> = plan.unmerged.iter().chain(&changed_meanwhile).collect();
    remember(project, &status, &open, request)?;
    project::remove_tree(&project.area(INCOMING))?;
    let changed_meanwhile = changed_meanwhile.into_iter().collect();
    Ok(PullResult { status, updated, removed, merged, unmerged: plan.unmerged, changed_meanwhile })
}

/// Writes a downloaded file to its place until the pull is applied.
fn write_incoming(project: &ControllerProject, path: &ControllerPath, bytes: &[u8]) -> Result<(), ControllerError> {
    project::write_copy(&project.stored(INCOMING, path), bytes)
}

/// Checks that each requested application exists on the controller, or did at the last pull. A wrong name would otherwise
/// be an application without files.
fn check_applications_exist(
    project: &ControllerProject,
    files: &mut dyn ControllerFiles,
    folders: &[ControllerPath],
    status: &ProjectStatus,
) -> Result<(), ControllerError> {
    let (applications, base) = (ControllerPath::applications(), project.base());
    let is_known = |folder: &ControllerPath| status.controller.keys().chain(base.keys()).any(|path| path.is_in(folder));
    let mut requested = folders.iter().filter(|folder| **folder != applications && folder.is_in(&applications));
    match requested.find(|folder| !is_known(folder)) {
        None => Ok(()),
        Some(folder) => {
            Err(ControllerError::NoApplication { folder: folder.clone(), present: application_names(files)? })
        }
    }
}

/// Removes the stored contents of files that the controller no longer has, so that their names are free.
fn remove_old_base(
    project: &ControllerProject,
    status: &ProjectStatus,
    folders: &[ControllerPath],
) -> Result<(), ControllerError> {
    for path in project.base().keys().filter(|path| path.is_in_any(folders)) {
        if !status.controller.contains_key(path) {
            apply::remove_with_folders(&project.area(BASE), path)?;
        }
    }
    Ok(())
}

/// Stores the digests and contents for the next comparison. Files with an open conflict keep the old ones, so that they
/// are conflicts in the next comparison, too.
fn remember(
    project: &mut ControllerProject,
    status: &ProjectStatus,
    open: &BTreeSet<&ControllerPath>,
    request: PullRequest<'_>,
) -> Result<(), ControllerError> {
    let base = project.base();
    for path in status.controller.keys().filter(|path| !open.contains(path)) {
        let is_stored = base.get(path) == status.controller.get(path) && project.stored(BASE, path).is_file();
        let incoming = project.stored(INCOMING, path);
        // A new file was moved to its place before.
        if !is_stored && incoming.exists() {
            apply::free_base_name(project, path)?;
            project::move_file(&incoming, &project.stored(BASE, path))?;
        }
    }
    let mut state = ProjectState::new(request.address, request.connection, request.identity);
    let known = project.state.as_ref().map(|state| state.folders.clone()).unwrap_or_default();
    state.folders = ControllerPath::outermost(known.into_iter().chain(request.folders.iter().cloned()));
    let controller = status.controller.clone().into_iter().filter(|(path, _)| !open.contains(path));
    let kept = base.into_iter().filter(|(path, _)| open.contains(path) || !path.is_in_any(&request.folders));
    state.files = kept.chain(controller).collect();
    project.state = Some(state);
    project.save()
}
