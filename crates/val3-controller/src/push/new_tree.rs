//! The files that the controller will have after a push, for the check before it.

use std::collections::BTreeSet;

use camino::Utf8PathBuf;

use super::plan::PushPlan;
use crate::error::ControllerError;
use crate::path::ControllerPath;
use crate::project::{self, ControllerProject, local};
use crate::status::ProjectStatus;

/// Writes the files to `.val3/checked`, so that settings above the project apply. Returns the folder.
///
/// # Errors
/// If a file cannot be read or written, or the controller's content of a file is not stored.
pub fn write_new_tree(
    project: &ControllerProject,
    status: &ProjectStatus,
    plan: &PushPlan,
) -> Result<Utf8PathBuf, ControllerError> {
    let folder = project.area("checked");
    project::remove_tree(&folder)?;
    let unselected: BTreeSet<&ControllerPath> = plan.unselected.iter().collect();
    let paths: BTreeSet<&ControllerPath> = status.local.keys().chain(status.controller.keys()).collect();
    for path in paths {
        let bytes = match (unselected.contains(path), status.controller.contains_key(path)) {
            (true, true) => {
                let content = project.base_content(path);
                content.ok_or_else(|| local(&project.stored("base", path), &"run `val3 pull` to store it again"))?
            }
            (false, _) if status.local.contains_key(path) => project::read(&project.local(path))?,
            _ => continue,
        };
        project::write_copy(&folder.join(path.as_str()), &bytes)?;
    }
    Ok(folder)
}

/// Removes the files of [`write_new_tree`].
///
/// # Errors
/// If they cannot be removed.
pub fn remove_new_tree(project: &ControllerProject) -> Result<(), ControllerError> {
    project::remove_tree(&project.area("checked"))
}
