//! Applications and folders that a pull would remove completely.

use std::collections::BTreeSet;

use super::plan::PullPlan;
use crate::error::ControllerError;
use crate::path::ControllerPath;
use crate::status::ProjectStatus;

/// Checks that no application, and no pulled folder of settings, loses all files: a wrong address, a profile without the
/// right to read, or an erased controller would otherwise erase the local files, too.
pub(super) fn check(
    plan: &PullPlan,
    status: &ProjectStatus,
    folders: &[ControllerPath],
) -> Result<(), ControllerError> {
    let groups: BTreeSet<ControllerPath> = plan.removals.iter().flat_map(|path| groups(path, folders)).collect();
    let is_gone = |group: &ControllerPath| !status.controller.keys().any(|path| path.is_in(group));
    let gone = ControllerPath::outermost(groups.into_iter().filter(is_gone));
    let count = |group: &ControllerPath| plan.removals.iter().filter(|path| path.is_in(group)).count();
    let gone: Vec<(ControllerPath, usize)> = gone.into_iter().map(|group| (group.clone(), count(&group))).collect();
    if gone.is_empty() { Ok(()) } else { Err(ControllerError::RemovesFolders(gone)) }
}

/// Folders that belong together and that contain a file: its uppermost folder below the applications, the folder of a
/// project file, or the pulled folder of settings.
fn groups(path: &ControllerPath, folders: &[ControllerPath]) -> Vec<ControllerPath> {
    let applications = ControllerPath::applications();
    if !path.is_in(&applications) {
        return folders.iter().filter(|folder| path.is_in(folder)).cloned().collect();
    }
    let above = std::iter::successors(path.parent(), ControllerPath::parent);
    let uppermost = above.into_iter().find(|folder| folder.parent().as_ref() == Some(&applications));
    let own = path.parent().filter(|folder| path.is_project() && *folder != applications);
    uppermost.into_iter().chain(own).collect()
}
