//! Applications that a push would remove from the controller.

use std::collections::BTreeSet;

use super::plan::PlannedChange;
use crate::error::ControllerError;
use crate::path::ControllerPath;
use crate::status::ProjectStatus;

/// Returns the applications that have no project file after the push, by their folders below `usr/usrapp`.
///
/// # Errors
/// If no application is left here, because a missing folder is more probable than the wish for an empty controller; and
/// if settings would be removed, without which a controller may not start.
pub(super) fn removed_applications(
    changes: &[PlannedChange],
    status: &ProjectStatus,
) -> Result<BTreeSet<ControllerPath>, ControllerError> {
    let applications = ControllerPath::applications();
    let removed = || changes.iter().filter(|change| change.new.is_none()).map(|change| &change.path);
    let settings: Vec<ControllerPath> = removed().filter(|path| !path.is_in(&applications)).cloned().collect();
    if !settings.is_empty() {
        return Err(ControllerError::RemovesSettings(settings));
    }
    let local = || status.local.keys().filter(|path| path.is_in(&applications));
    let kept: BTreeSet<ControllerPath> = local().filter_map(project_folder).collect();
    let folders: BTreeSet<ControllerPath> =
        removed().filter_map(project_folder).filter(|folder| !kept.contains(folder)).collect();
    let is_empty = local().next().is_none() && removed().next().is_some();
    if kept.is_empty() && (is_empty || !folders.is_empty()) {
        return Err(ControllerError::NoApplicationLeft(removed().count()));
    }
    Ok(folders)
}

/// Folder of a project file; `None` for other files.
fn project_folder(path: &ControllerPath) -> Option<ControllerPath> {
    path.is_project().then(|| path.parent()).flatten()
}
