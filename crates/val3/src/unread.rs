//! Unreadable files and folders, because of which a report without findings would be wrong.

use rustc_hash::FxHashSet;
use val3_analysis::db::{File, FileStatus, Sources};
use val3_analysis::load::Workspace;
use val3_check::CheckUnit;
use val3_check::diagnostic::Diagnostic;

use crate::paths::Paths;
use crate::user_error::UserError;

/// Rule about unreadable files. Its findings make a check incomplete.
pub(crate) const UNREADABLE_FILE: &str = "V0502";

/// Rule about archives in a checked folder. Its findings are about files that were not read.
pub(crate) const UNREAD_ARCHIVE: &str = "V0544";

/// Whether the finding is about an unreadable file.
pub(crate) fn is_unreadable(finding: &Diagnostic) -> bool {
    finding.rule.code == UNREADABLE_FILE
}

fn unread(path: &str, reason: &str) -> UserError {
    UserError::new(format!("cannot read `{path}`: {reason}")).with_help("the findings that depend on it are missing")
}

/// Unreadable files and folders of a check.
pub(crate) struct Unread {
    /// Whether files of the checked units are unreadable. They have findings.
    has_findings: bool,
    /// Errors about folders, and about library files that are not checked.
    errors: Vec<UserError>,
}

impl Unread {
    /// Collects the unreadable files of the workspace. `units` are the checked units.
    pub(crate) fn new(workspace: &Workspace, units: &[CheckUnit], paths: &Paths) -> Self {
        let db = &workspace.db;
        let checked: FxHashSet<File> = units.iter().map(|unit| unit.file(db)).collect();
        let has_findings = checked.iter().any(|file| matches!(file.status(db), FileStatus::Unreadable(_)));
        let mut found = workspace.unreadable.clone();
        for file in Sources::get(db).files(db).values().filter(|file| !checked.contains(*file)) {
            if let FileStatus::Unreadable(reason) = file.status(db) {
                found.push((file.path(db).clone(), reason.clone()));
            }
        }
        found.sort_unstable();
        Self { has_findings, errors: found.iter().map(|(path, reason)| unread(&paths.shown(path), reason)).collect() }
    }

    /// Whether all files were read.
    pub(crate) fn is_empty(&self) -> bool {
        !self.has_findings && self.errors.is_empty()
    }

    /// Returns the errors about files and folders without a finding, and about baselines that were not written for this
    /// reason.
    pub(crate) fn into_errors(mut self, has_unwritten_baselines: bool) -> Vec<UserError> {
        if has_unwritten_baselines {
            let message = "the baseline is not changed, because files could not be read";
            self.errors.push(UserError::new(message).with_help("their known findings would be lost"));
        }
        self.errors
    }
}
