//! The files that the controller will have after a push, for the check before it.

use std::collections::BTreeSet;

use camino::Utf8PathBuf;

use super::load_order::{affected, project_texts};
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
    for path in plan.new_files(status) {
        project::write_copy(&folder.join(path.as_str()), &new_content(project, plan, path)?)?;
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

/// Returns the project files that the push affects, with their contents after the push: changed applications, and direct
/// and indirect users.
///
/// # Errors
/// If a project file cannot be read, or the controller's content is not stored.
pub fn affected_projects(
    project: &ControllerProject,
    status: &ProjectStatus,
    plan: &PushPlan,
) -> Result<BTreeSet<ControllerPath>, ControllerError> {
    let projects = project_texts(plan.new_files(status), |path| new_content(project, plan, path))?;
    Ok(affected(&projects, plan.changes.iter().map(|change| &change.path)))
}

/// Content of a file after the push: the local one, unless its change is not selected.
fn new_content(
    project: &ControllerProject,
    plan: &PushPlan,
    path: &ControllerPath,
) -> Result<Vec<u8>, ControllerError> {
    if !plan.unselected.contains(path) {
        return project::read(&project.local(path));
    }
    let content = project.base_content(path);
    content.ok_or_else(|| local(&project.stored("base", path), &"run `val3 pull` to store it again"))
}
