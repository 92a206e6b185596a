//! Checks files in memory, for tests.

#[cfg(test)]
mod pages;

use std::convert::Infallible;
use std::ops::Range;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::Db;
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::Memory;
use val3_syntax::TextSlice;
use val3_syntax::encoding::decode;

use crate::diagnostic::{Diagnostic, Fix};
use crate::fix::{AppliedFixes, FixTarget, TrialWorkspace, add_suppressions, apply_fixes};
use crate::rule::Severity;
use crate::settings::{RuleSelection, WorkspaceSettings};
use crate::{check_unit, finish, units};

/// Codes of rules about complete projects. An example on a page is an excerpt, in the form of s7 whatever it declares.
pub const OF_WHOLE_PROJECTS: [&str; 11] =
    ["V0113", "V0114", "V0115", "V0116", "V0117", "V0118", "V0119", "V0120", "V0341", "V0533", "V0534"];

/// One finding with its line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CheckedFinding {
    /// Code, for example `V0203`.
    pub code: &'static str,
    /// Level.
    pub severity: Severity,
    /// Path of the file.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Message.
    pub message: String,
}

/// Checks all projects in `files`, which are pairs of path and bytes. A relative path starts at the root.
///
/// # Panics
/// If there is no project in the files.
pub fn check_files(files: &[(String, Vec<u8>)]) -> Vec<CheckedFinding> {
    check_selected(files, &RuleSelection::default())
}

/// As [`check_files`], with the selection of a command line.
///
/// # Panics
/// As [`check_files`].
pub fn check_selected(files: &[(String, Vec<u8>)], selection: &RuleSelection) -> Vec<CheckedFinding> {
    try_check(files, selection).unwrap_or_else(|error| panic!("{error}"))
}

/// As [`check_selected`], also for files without a project or with an invalid `val3.toml`.
///
/// # Errors
/// The reason why nothing is checked.
pub fn try_check(files: &[(String, Vec<u8>)], selection: &RuleSelection) -> Result<Vec<CheckedFinding>, String> {
    let (workspace, found) = try_checked(files, selection)?;
    let db = &workspace.db;
    let mut findings: Vec<CheckedFinding> = found
        .iter()
        .map(|diagnostic| {
            let before = usize::from(diagnostic.place.range.start());
            let text = diagnostic.place.file.text(db);
            CheckedFinding {
                code: diagnostic.rule.code,
                severity: diagnostic.severity,
                file: shown(diagnostic.place.file.path(db).as_str(), files),
                line: 1 + text.part(..before).matches('\n').count(),
                message: diagnostic.message.clone(),
            }
        })
        .collect();
    findings.sort_by(|a, b| (&a.file, a.line, a.code).cmp(&(&b.file, b.line, b.code)));
    Ok(findings)
}

/// A fix that is offered for a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OfferedFix {
    /// Code of the finding.
    pub code: &'static str,
    /// Title of the fix.
    pub title: String,
    /// Whether it may be applied without confirmation.
    pub safe: bool,
    /// Edits: file, range in the decoded text, and new text.
    pub edits: Vec<(String, Range<usize>, String)>,
}

/// Fixes of all findings in `files`, in the order of each unit's findings.
///
/// # Panics
/// If there is no project in the files.
pub fn offered_fixes(files: &[(String, Vec<u8>)]) -> Vec<OfferedFix> {
    let (workspace, found) = checked(files, &RuleSelection::default());
    let fixes = found.iter().filter_map(|diagnostic| {
        let Fix { title, safe, edits, .. } = diagnostic.fix.as_ref()?;
        let edits = edits.iter().map(|edit| {
            let file = shown(edit.file.path(&workspace.db).as_str(), files);
            (file, edit.range.into(), edit.text.clone())
        });
        let edits = edits.collect();
        Some(OfferedFix { code: diagnostic.rule.code, title: title.clone(), safe: *safe, edits })
    });
    fixes.collect()
}

/// Files after all fixes, safe or not.
///
/// # Panics
/// If there is no project in the files.
pub fn fixed_files(files: &[(String, Vec<u8>)]) -> Vec<(String, Vec<u8>)> {
    let mut target = MemoryTarget::new(files);
    let Ok(AppliedFixes { settled, .. }) = apply_fixes(&mut target, true);
    assert!(settled, "the fixes do not settle");
    target.files
}

/// Files with comments that silence the findings in programs.
///
/// # Panics
/// If there is no project in the files.
pub fn silenced_files(files: &[(String, Vec<u8>)]) -> Vec<(String, Vec<u8>)> {
    let mut target = MemoryTarget::new(files);
    let Ok(_) = add_suppressions(&mut target);
    target.files
}

/// Files in memory to which fixes are applied. They are loaded once more after each change.
pub(crate) struct MemoryTarget {
    files: Vec<(String, Vec<u8>)>,
    checked: (Workspace, Vec<Diagnostic>),
}

impl MemoryTarget {
    pub(crate) fn new(files: &[(String, Vec<u8>)]) -> Self {
        Self { files: files.to_vec(), checked: checked(files, &RuleSelection::default()) }
    }
}

impl FixTarget for MemoryTarget {
    type Error = Infallible;

    fn findings(&mut self) -> Result<Vec<Diagnostic>, Infallible> {
        Ok(self.checked.1.clone())
    }

    fn occurrences(&mut self) -> Result<Vec<Diagnostic>, Infallible> {
        self.findings()
    }
}

impl TrialWorkspace for MemoryTarget {
    fn db(&self) -> &dyn Db {
        &self.checked.0.db
    }

    fn all_findings(&mut self) -> Vec<Diagnostic> {
        self.checked.1.clone()
    }

    fn set_texts<'t>(&mut self, texts: impl Iterator<Item = (&'t Utf8Path, &'t Arc<str>)>) {
        for (path, text) in texts {
            let path = shown(path.as_str(), &self.files);
            if let Some((_, bytes)) = self.files.iter_mut().find(|(known, _)| *known == path) {
                *bytes = decode(bytes.clone()).encoding.encode(text);
            }
        }
        self.checked = checked(&self.files, &RuleSelection::default());
    }
}

fn checked(files: &[(String, Vec<u8>)], selection: &RuleSelection) -> (Workspace, Vec<Diagnostic>) {
    try_checked(files, selection).unwrap_or_else(|error| panic!("{error}"))
}

fn try_checked(files: &[(String, Vec<u8>)], selection: &RuleSelection) -> Result<(Workspace, Vec<Diagnostic>), String> {
    let rooted = |(path, bytes): &(String, Vec<u8>)| (Utf8PathBuf::from("/").join(path), bytes.clone());
    let system = Memory::new(files.iter().map(rooted));
    let workspace = load(&system, &[Utf8PathBuf::from("/")]).map_err(|error| error.to_string())?;
    let db = &workspace.db;
    let units = units(db, &workspace.projects);
    let settings =
        WorkspaceSettings::new(db, &workspace.projects, selection).map_err(|errors| format!("{errors:?}"))?;
    let checked = units.iter().map(|unit| check_unit(db, *unit, &settings)).sum();
    let found = finish(db, &units, &settings, checked).findings;
    Ok((workspace, found))
}

/// Path in the form used by the caller.
fn shown(path: &str, files: &[(String, Vec<u8>)]) -> String {
    let relative = path.strip_prefix('/').unwrap_or(path);
    let given = files.iter().find(|(given, _)| given == path || given == relative);
    given.map_or(path, |(given, _)| given).to_owned()
}
