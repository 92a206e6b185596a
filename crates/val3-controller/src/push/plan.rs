//! Plan of a push as data.

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};

use super::load_order::{LoadOrder, project_texts};
use super::removals::removed_applications;
use crate::compare::FileDifference;
use crate::digest::FileDigest;
use crate::error::ControllerError;
use crate::path::ControllerPath;
use crate::project::{self, ControllerProject};
use crate::rules::is_protected;
use crate::status::ProjectStatus;

/// Planned change to a file on the controller.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct PlannedChange {
    /// The file.
    pub path: ControllerPath,
    /// Present content; `None` if the file is new.
    pub old: Option<FileDigest>,
    /// New content; `None` if the file is removed.
    pub new: Option<FileDigest>,
}

/// Changes of a push in the order in which they become effective.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PushPlan {
    /// Programs and data, then project files, then removals; libraries and types before their users.
    pub changes: Vec<PlannedChange>,
    /// Changed local files that are not selected.
    pub unselected: Vec<ControllerPath>,
    /// Folders of applications that are removed from the controller.
    pub removed_applications: BTreeSet<ControllerPath>,
}

impl PushPlan {
    /// Plans the upload of all local changes in the selected folders and files.
    ///
    /// # Errors
    /// If a selected file has changed on the controller, or is never written; or if no application would remain.
    pub fn new(
        project: &ControllerProject,
        status: &ProjectStatus,
        selection: &[ControllerPath],
    ) -> Result<Self, ControllerError> {
        let mut plan = Self::default();
        let (mut conflicts, mut outdated, mut protected) = (Vec::new(), Vec::new(), Vec::new());
        for (path, difference) in &status.differences {
            let is_selected = selection.iter().any(|folder| path.is_in(folder));
            match difference {
                FileDifference::Local(_) if !is_selected => plan.unselected.push(path.clone()),
                FileDifference::Local(_) if is_protected(path) => protected.push(path.clone()),
                FileDifference::Local(_) => plan.changes.push(PlannedChange {
                    path: path.clone(),
                    old: status.controller.get(path).cloned(),
                    new: status.local.get(path).cloned(),
                }),
                FileDifference::Conflict { .. } if is_selected => conflicts.push(path.clone()),
                FileDifference::Controller(_) if is_selected => outdated.push(path.clone()),
                FileDifference::Conflict { .. } | FileDifference::Controller(_) | FileDifference::Alike(_) => {}
            }
        }
        if !protected.is_empty() {
            return Err(ControllerError::Protected(protected));
        }
        if !conflicts.is_empty() {
            return Err(ControllerError::Conflicts(conflicts));
        }
        if !outdated.is_empty() {
            return Err(ControllerError::Outdated(outdated));
        }
        plan.removed_applications = removed_applications(&plan.changes, status)?;
        let projects = project_texts(status.local.keys(), |path| project::read(&project.local(path)))?;
        plan.sort(&LoadOrder::new(&projects));
        Ok(plan)
    }

    fn sort(&mut self, order: &LoadOrder) {
        self.changes.sort_by_cached_key(|change| {
            let is_project = change.path.is_project();
            // The project file of a removed application is removed first, so that it cannot be loaded in part.
            let step = match (&change.new, is_project) {
                (Some(_), false) => 0,
                (Some(_), true) => 1,
                (None, true) => 2,
                (None, false) => 3,
            };
            (step, order.rank(&change.path), change.path.clone())
        });
    }

    /// Uploaded files.
    pub fn uploads(&self) -> impl Iterator<Item = &PlannedChange> {
        self.changes.iter().filter(|change| change.new.is_some())
    }

    /// Total size of the uploads in bytes.
    #[must_use]
    pub fn upload_bytes(&self) -> u64 {
        self.uploads().filter_map(|change| change.new.as_ref()).map(|digest| digest.size).sum()
    }

    /// Applications whose files change, by their folders below `usr/usrapp`.
    #[must_use]
    pub fn applications(&self) -> Vec<String> {
        let names: BTreeSet<&str> = self.changes.iter().filter_map(|change| change.path.application()).collect();
        names.into_iter().map(str::to_owned).collect()
    }

    /// Changed applications that exist after the push, by their folders below `usr/usrapp`.
    #[must_use]
    pub fn remaining_applications(&self) -> Vec<String> {
        self.applications().into_iter().filter(|name| !self.removes(name)).collect()
    }

    /// Whether the push removes this application: its project file is removed, and none of its files is uploaded.
    fn removes(&self, application: &str) -> bool {
        let changes = || self.changes.iter().filter(|change| change.path.application() == Some(application));
        changes().all(|change| change.new.is_none()) && changes().any(|change| change.path.is_project())
    }

    /// Files that the controller has after the push, in the compared folders.
    pub fn new_files<'s>(&self, status: &'s ProjectStatus) -> impl Iterator<Item = &'s ControllerPath> {
        let unselected: BTreeSet<&ControllerPath> = self.unselected.iter().collect();
        let paths: BTreeSet<&ControllerPath> = status.local.keys().chain(status.controller.keys()).collect();
        paths.into_iter().filter(move |path| match unselected.contains(path) {
            true => status.controller.contains_key(*path),
            false => status.local.contains_key(*path),
        })
    }

    /// Whether settings change, which the controller reads when it starts.
    #[must_use]
    pub fn needs_restart(&self) -> bool {
        self.changes.iter().any(|change| !change.path.is_in(&ControllerPath::applications()))
    }
}
