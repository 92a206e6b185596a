//! Plan of a pull: what happens to each local file.

use super::request::{ConflictVersions, MergeConflict, PullDecisions};
use crate::compare::{FileDifference, SideChange};
use crate::digest::FileDigest;
use crate::error::ControllerError;
use crate::path::ControllerPath;
use crate::project::{self, ControllerProject, INCOMING};
use crate::status::ProjectStatus;

/// Changes of the local files.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct PullPlan {
    /// Files that get the controller's version.
    pub(super) updates: Vec<ControllerPath>,
    /// Files that the controller no longer has.
    pub(super) removals: Vec<ControllerPath>,
    /// Merged contents.
    pub(super) merges: Vec<(ControllerPath, Vec<u8>)>,
    /// Conflicts that remain.
    pub(super) unmerged: Vec<ControllerPath>,
}

impl PullPlan {
    /// Plans the pull of downloaded files. Local changes that the controller does not contradict stay.
    ///
    /// # Errors
    /// If a conflict is neither decided nor merged, a decision applies to no file, or a file cannot be read.
    pub(super) fn new(
        project: &ControllerProject,
        status: &ProjectStatus,
        decisions: &PullDecisions,
        merge: Option<&mut MergeConflict<'_>>,
    ) -> Result<Self, ControllerError> {
        check_decisions(status, decisions)?;
        let mut plan = Self::default();
        let mut open = Vec::new();
        for (path, difference) in &status.differences {
            let takes_controller = path.is_in_any(&decisions.controller);
            match difference {
                FileDifference::Controller(SideChange::Removed) => plan.removals.push(path.clone()),
                FileDifference::Controller(_) => plan.updates.push(path.clone()),
                FileDifference::Local(SideChange::Removed) if takes_controller => plan.updates.push(path.clone()),
                FileDifference::Conflict { controller: SideChange::Removed, .. } if takes_controller => {
                    plan.removals.push(path.clone());
                }
                FileDifference::Conflict { .. } if takes_controller => plan.updates.push(path.clone()),
                FileDifference::Conflict { .. } if path.is_in_any(&decisions.local) => {}
                FileDifference::Conflict { .. } => open.push(path),
                FileDifference::Local(_) | FileDifference::Alike(_) => {}
            }
        }
        match merge {
            None if !open.is_empty() => Err(ControllerError::Conflicts(open.into_iter().cloned().collect())),
            None => Ok(plan),
            Some(merge) => {
                open.into_iter().try_for_each(|path| plan.merge(project, status, path, merge))?;
                Ok(plan)
            }
        }
    }

    /// Merges a conflict. A file that one side has removed and the other side has changed is kept.
    fn merge(
        &mut self,
        project: &ControllerProject,
        status: &ProjectStatus,
        path: &ControllerPath,
        merge: &mut MergeConflict<'_>,
    ) -> Result<(), ControllerError> {
        let Some(digest) = status.local.get(path) else {
            self.updates.push(path.clone());
            return Ok(());
        };
        if !status.controller.contains_key(path) {
            return Ok(());
        }
        let versions = ConflictVersions {
            base: project.base_content(path).or_else(|| (!project.had_file(path)).then(Vec::new)),
            local: project::read(&project.local(path))?,
            controller: project::read(&project.stored(INCOMING, path))?,
        };
        if FileDigest::of(&versions.local) != *digest {
            return Err(ControllerError::LocalChanged(path.clone()));
        }
        match merge(path, &versions) {
            Some(content) => self.merges.push((path.clone(), content)),
            None => self.unmerged.push(path.clone()),
        }
        Ok(())
    }
}

/// Checks that each decision applies to a file, so that a wrong path is not a decision without effect, and that no file is
/// decided for both sides.
fn check_decisions(status: &ProjectStatus, decisions: &PullDecisions) -> Result<(), ControllerError> {
    if let Some(path) = status.differences.keys().find(|path| decisions.are_contradictory(path)) {
        return Err(ControllerError::DecidedTwice(path.clone()));
    }
    let local = decisions.local.iter().find(|folder| !has_difference(status, folder, can_keep_local));
    let controller = decisions.controller.iter().find(|folder| !has_difference(status, folder, can_take_controller));
    match local.or(controller) {
        None => Ok(()),
        Some(path) => Err(ControllerError::NoConflict(path.clone())),
    }
}

/// Whether the folder contains a file with such a difference.
fn has_difference(status: &ProjectStatus, folder: &ControllerPath, is_such: fn(&FileDifference) -> bool) -> bool {
    status.differences.iter().any(|(path, difference)| path.is_in(folder) && is_such(difference))
}

/// Whether the decision for the local version has an effect on this difference.
fn can_keep_local(difference: &FileDifference) -> bool {
    matches!(difference, FileDifference::Conflict { .. })
}

/// Whether the decision for the controller's version has an effect on this difference: it also restores removed files.
fn can_take_controller(difference: &FileDifference) -> bool {
    matches!(difference, FileDifference::Conflict { .. } | FileDifference::Local(SideChange::Removed))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decision_applies_to_conflicts_and_the_controllers_version_also_to_removed_files() {
        let conflict = FileDifference::Conflict { local: SideChange::Modified, controller: SideChange::Modified };
        let removed = FileDifference::Local(SideChange::Removed);
        assert!(can_keep_local(&conflict) && can_take_controller(&conflict));
        assert!(!can_keep_local(&removed) && can_take_controller(&removed));
        assert!(!can_take_controller(&FileDifference::Local(SideChange::Modified)));
    }
}
