//! The files that the controller will have after a push, for the check before it.

use std::collections::BTreeSet;

use camino::{Utf8Path, Utf8PathBuf};
use val3_files::{ProcessLock, Unwritable};

use super::load_order::{affected, project_texts};
use super::plan::PushPlan;
use crate::error::ControllerError;
use crate::path::ControllerPath;
use crate::project::{self, ControllerProject, local};
use crate::status::ProjectStatus;

/// Folder of the project's own data with the trees. Each process has its own tree, so that a check in an editor and a push
/// on the command line can run at the same time.
const AREA: &str = "checked";

/// Maximum number of trees.
const TREES: usize = 100;

/// Written files of a new tree. Only this process reads and writes the folder.
#[derive(Debug)]
pub struct WrittenTree {
    folder: Utf8PathBuf,
    _lock: ProcessLock,
}

impl WrittenTree {
    /// Writes the files below `.val3/checked`, so that settings above the project apply.
    ///
    /// # Errors
    /// If a file cannot be read or written, or the controller's content of a file is not stored.
    pub fn write(
        project: &ControllerProject,
        status: &ProjectStatus,
        plan: &PushPlan,
    ) -> Result<Self, ControllerError> {
        let tree = Self::lock(project)?;
        // Files of a killed process.
        project::remove_tree(&tree.folder)?;
        for path in plan.new_files(status) {
            project::write_copy(&tree.folder.join(path.as_str()), &new_content(project, plan, path)?)?;
        }
        Ok(tree)
    }

    /// Locks the first folder that no other process has locked.
    fn lock(project: &ControllerProject) -> Result<Self, ControllerError> {
        let area = project.area(AREA);
        val3_files::create_folders(&area).map_err(|reason| local(&area, &reason))?;
        for number in 1..=TREES {
            let path = area.join(format!("{number}.lock"));
            match ProcessLock::acquire(&path) {
                Ok(lock) => return Ok(Self { folder: area.join(number.to_string()), _lock: lock }),
                Err(Unwritable::Busy) => {}
                Err(reason) => return Err(local(&path, &reason)),
            }
        }
        Err(ControllerError::Running)
    }

    /// Folder that contains `usr`.
    #[must_use]
    pub fn folder(&self) -> &Utf8Path {
        &self.folder
    }

    /// Removes the files.
    ///
    /// # Errors
    /// If they cannot be removed.
    pub fn remove(self) -> Result<(), ControllerError> {
        project::remove_tree(&self.folder)
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_check_has_its_own_folder() {
        let kept = tempfile::tempdir().unwrap();
        let project = ControllerProject::open(Utf8Path::from_path(kept.path()).unwrap()).unwrap();
        let [first, second] = [(); 2].map(|()| WrittenTree::lock(&project).unwrap());
        assert!(first.folder().ends_with(".val3/checked/1") && second.folder().ends_with(".val3/checked/2"));
        std::fs::create_dir(first.folder()).unwrap();
        let folder = first.folder().to_owned();
        first.remove().unwrap();
        assert!(!folder.exists());
        assert_eq!(WrittenTree::lock(&project).unwrap().folder(), folder);
    }
}
