//! Local files where a pull needs a folder, and local folders where it needs a file.

use std::collections::BTreeSet;

use val3_files::FolderEntryKind;

use super::plan::PullPlan;
use crate::error::ControllerError;
use crate::path::ControllerPath;
use crate::project::{ControllerProject, local};

/// Checks that all files can get their names after the removals, so that a pull does not stop in the middle.
pub(super) fn check(project: &ControllerProject, plan: &PullPlan) -> Result<(), ControllerError> {
    let removed: BTreeSet<&ControllerPath> = plan.removals.iter().collect();
    for path in &plan.updates {
        let obstacle = file_above(project, path, &removed)
            .map_or_else(|| file_below(project, path, &removed), |above| Ok(Some(above)))?;
        if let Some(obstacle) = obstacle {
            return Err(ControllerError::Obstacle { path: path.clone(), obstacle });
        }
    }
    Ok(())
}

/// A file that remains where a folder above `path` is needed.
fn file_above(
    project: &ControllerProject,
    path: &ControllerPath,
    removed: &BTreeSet<&ControllerPath>,
) -> Option<ControllerPath> {
    let mut above = std::iter::successors(path.parent(), ControllerPath::parent);
    above.find(|folder| !removed.contains(folder) && project.local(folder).is_file())
}

/// A file that remains below `path`, also an ignored one.
fn file_below(
    project: &ControllerProject,
    path: &ControllerPath,
    removed: &BTreeSet<&ControllerPath>,
) -> Result<Option<ControllerPath>, ControllerError> {
    let mut open = vec![path.clone()];
    while let Some(folder) = open.pop() {
        let at = project.local(&folder);
        if !at.is_dir() {
            continue;
        }
        for entry in val3_files::list_folder(&at).map_err(|reason| local(&at, &reason))? {
            let inner = folder.child(&entry.name).map_err(ControllerError::Name)?;
            match entry.kind {
                FolderEntryKind::Folder => open.push(inner),
                _ if removed.contains(&inner) => {}
                _ => return Ok(Some(inner)),
            }
        }
    }
    Ok(None)
}
