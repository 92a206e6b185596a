//! Changes of local files. A file that was changed since the comparison is kept.

use std::collections::BTreeSet;

use camino::Utf8Path;

use super::plan::PullPlan;
use crate::digest::FileDigest;
use crate::error::ControllerError;
use crate::path::ControllerPath;
use crate::project::{self, BASE, ControllerProject, INCOMING, local};
use crate::status::ProjectStatus;

/// Executes a plan: removals first, because a folder may replace a file and a file a folder. Returns the files that
/// another program has changed since the comparison, and which were therefore not written.
pub(super) fn apply(
    project: &ControllerProject,
    status: &ProjectStatus,
    plan: &PullPlan,
) -> Result<BTreeSet<ControllerPath>, ControllerError> {
    let mut changed = BTreeSet::new();
    for path in &plan.removals {
        if is_unchanged(project, status, path)? {
            remove_with_folders(project.folder(), path)?;
        } else {
            changed.insert(path.clone());
        }
    }
    for path in &plan.updates {
        if is_unchanged(project, status, path)? {
            update(project, status, path)?;
        } else {
            changed.insert(path.clone());
        }
    }
    for (path, content) in &plan.merges {
        if is_unchanged(project, status, path)? {
            project::write(&project.local(path), content)?;
        } else {
            changed.insert(path.clone());
        }
    }
    Ok(changed)
}

/// Whether a local file still has the content that was compared.
fn is_unchanged(
    project: &ControllerProject,
    status: &ProjectStatus,
    path: &ControllerPath,
) -> Result<bool, ControllerError> {
    let at = project.local(path);
    let present = if at.is_file() { Some(FileDigest::of(&project::read(&at)?)) } else { None };
    Ok(present.as_ref() == status.local.get(path))
}

/// Copies the controller's version.
fn update(project: &ControllerProject, status: &ProjectStatus, path: &ControllerPath) -> Result<(), ControllerError> {
    let incoming = project.stored(INCOMING, path);
    let bytes = project::read(&incoming)?;
    if status.local.contains_key(path) {
        return project::write(&project.local(path), &bytes);
    }
    remove_empty_folders(&project.local(path))?;
    free_base_name(project, path)?;
    // A new file is moved, which does not wait for the disk and is complete.
    project::write_copy(&project.stored(BASE, path), &bytes)?;
    project::move_file(&incoming, &project.local(path))
}

/// Removes obstacles at the path of a stored copy, for example after a pull that was killed.
pub(super) fn free_base_name(project: &ControllerProject, path: &ControllerPath) -> Result<(), ControllerError> {
    for folder in std::iter::successors(path.parent(), ControllerPath::parent) {
        let at = project.stored(BASE, &folder);
        if at.is_file() {
            project::remove(&at)?;
        }
    }
    let at = project.stored(BASE, path);
    if at.is_dir() { project::remove_tree(&at) } else { Ok(()) }
}

/// Removes a folder that contains only folders, if it exists. A folder with a file is an error.
fn remove_empty_folders(at: &Utf8Path) -> Result<(), ControllerError> {
    if !at.is_dir() {
        return Ok(());
    }
    for entry in val3_files::list_folder(at).map_err(|reason| local(at, &reason))? {
        remove_empty_folders(&at.join(entry.name))?;
    }
    val3_files::remove_folder(at).map_err(|reason| local(at, &reason))
}

/// Removes the file `path` below `root` if it exists, and folders that are empty then, up to the pulled tree's upper two
/// levels such as `usr/usrapp`.
pub(super) fn remove_with_folders(root: &Utf8Path, path: &ControllerPath) -> Result<(), ControllerError> {
    const KEPT_DEPTH: usize = 2;
    project::remove(&root.join(path.as_str()))?;
    let folders = std::iter::successors(path.parent(), ControllerPath::parent);
    for folder in folders.take_while(|folder| folder.depth() > KEPT_DEPTH) {
        let at = root.join(folder.as_str());
        if !at.is_dir() {
            continue;
        }
        if !val3_files::list_folder(&at).map_err(|reason| local(&at, &reason))?.is_empty() {
            break;
        }
        val3_files::remove_folder(&at).map_err(|reason| local(&at, &reason))?;
    }
    Ok(())
}
