//! The errors of a workspace, compared before and after a change.

use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::{FxHashMap, FxHashSet};
use val3_analysis::db::Db;

use crate::diagnostic::Diagnostic;
use crate::rule::Severity;

/// A workspace whose texts can be changed temporarily.
pub trait TrialWorkspace {
    /// Database with the current files.
    fn db(&self) -> &dyn Db;

    /// Findings in the entire workspace.
    fn all_findings(&mut self) -> Vec<Diagnostic>;

    /// Replaces the texts of files. Loads files and projects that become part of the workspace.
    fn set_texts<'t>(&mut self, texts: impl Iterator<Item = (&'t Utf8Path, &'t Arc<str>)>);
}

/// Error identity: its rule, file and message. Its location may change.
type ErrorKey = (&'static str, Utf8PathBuf, String);

fn key(db: &dyn Db, found: &Diagnostic) -> ErrorKey {
    (found.rule.code, found.place.file.path(db).clone(), found.message.clone())
}

/// Errors of a workspace, with the number of occurrences.
#[derive(Debug, Default)]
pub(super) struct ErrorCounts(FxHashMap<ErrorKey, usize>);

impl ErrorCounts {
    /// Collects the errors of a workspace.
    pub(super) fn of(target: &mut impl TrialWorkspace) -> Self {
        let found = target.all_findings();
        Self::among(target.db(), &found)
    }

    /// Collects the errors in a list of findings.
    pub(super) fn among(db: &dyn Db, found: &[Diagnostic]) -> Self {
        let mut errors = Self::default();
        for error in found.iter().filter(|found| found.severity == Severity::Error) {
            *errors.0.entry(key(db, error)).or_default() += 1;
        }
        errors
    }

    fn count(&self, error: &ErrorKey) -> usize {
        self.0.get(error).copied().unwrap_or(0)
    }

    /// Whether the finding is an error that `before` does not contain.
    pub(super) fn adds(&self, db: &dyn Db, found: &Diagnostic, before: &Self) -> bool {
        let key = key(db, found);
        self.count(&key) > before.count(&key)
    }

    /// Files with errors that `before` does not contain.
    pub(super) fn files_with_more_than(&self, before: &Self) -> FxHashSet<Utf8PathBuf> {
        let new = self.0.iter().filter(|(error, count)| **count > before.count(error));
        new.map(|((_, path, _), _)| path.clone()).collect()
    }
}
