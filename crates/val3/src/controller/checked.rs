//! Check of the files that the controller will have after a push.

use std::collections::BTreeSet;

use camino::{Utf8Path, Utf8PathBuf};
use val3_check::settings::RuleSelection;
use val3_controller::{ControllerPath, ControllerProject, ProjectStatus, PushPlan, WrittenTree, affected_projects};

use super::note;
use crate::color::Color;
use crate::engine::Session;
use crate::format::{self, ReportFormat};
use crate::opening::OpenRequest;
use crate::output::{to_stderr, to_stderr_in_color};
use crate::report::{CheckReport, FindingSeverity};
use crate::user_error::UserError;
use crate::{selection, summary};

/// Result of the check before a push.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CheckOutcome {
    /// No errors.
    Clean,
    /// The findings, which are on the standard error output, have errors.
    Errors,
}

/// Checks all applications as they will be on the controller.
///
/// Applications that the push changes, and their users, are checked even if a configuration excludes them, and what the
/// controller's compiler rejects in them is an error whatever the configured levels are.
///
/// # Errors
/// The files cannot be read or written.
pub(crate) fn check_new_tree(
    project: &ControllerProject,
    status: &ProjectStatus,
    plan: &PushPlan,
    ignore: &[String],
    color: Color,
) -> Result<CheckOutcome, UserError> {
    let applications = ControllerPath::applications();
    let selection = selection::read(&[], &[], ignore)?;
    let projects = plan.new_files(status).filter(|path| path.is_in(&applications) && path.is_project());
    let all: BTreeSet<ControllerPath> = projects.filter_map(ControllerPath::parent).collect();
    if all.is_empty() {
        note("note: nothing was checked, because the controller has no application");
        return Ok(CheckOutcome::Clean);
    }
    let changed = affected_projects(project, status, plan)?.iter().filter_map(ControllerPath::parent).collect();
    let tree = NewTree { all, changed };
    // Settings count too: the check compares applications with inputs, outputs and lines.
    if plan.unselected.is_empty() {
        return tree.check(project.folder(), selection, color);
    }
    let written = WrittenTree::write(project, status, plan)?;
    let outcome = tree.check(written.folder(), selection, color);
    written.remove()?;
    outcome
}

/// Folders of applications after the push.
struct NewTree {
    all: BTreeSet<ControllerPath>,
    /// Applications that the push changes, and their users.
    changed: BTreeSet<ControllerPath>,
}

impl NewTree {
    /// Checks the applications below a local folder, which contains `usr`.
    fn check(&self, root: &Utf8Path, selection: RuleSelection, color: Color) -> Result<CheckOutcome, UserError> {
        let local = |path: &ControllerPath| root.join(path.as_str());
        let changed: Vec<Utf8PathBuf> = self.changed.iter().map(local).collect();
        // A named folder is never excluded.
        let asked = std::iter::once(local(&ControllerPath::applications())).chain(changed.iter().cloned()).collect();
        let ignored = selection.never.clone();
        let request = OpenRequest { asked, selection, ..OpenRequest::default() };
        let mut session = Session::open(&request)?;
        let unchecked: Vec<&str> =
            self.all.iter().filter(|path| !session.has_project(&local(path))).map(ControllerPath::as_str).collect();
        if !unchecked.is_empty() {
            note(&format!(
                "note: unchanged and not checked, because val3.toml excludes them: `{}`",
                unchecked.join("`, `")
            ));
        }
        let mut found = session.check()?;
        let mut refusals = session.refusals(&changed);
        refusals.retain(|finding| !ignored.contains(finding.rule.code));
        let is_refused = !refusals.is_empty();
        // The report keeps the first of equal findings; settings may change the level of the second.
        found.diagnostics.splice(0..0, refusals);
        let mut report = session.report(found);
        let outcome = match report.is_complete() && !is_refused && !report.reaches(FindingSeverity::Error) {
            true => CheckOutcome::Clean,
            false => CheckOutcome::Errors,
        };
        if outcome == CheckOutcome::Errors {
            report.findings.retain(|finding| finding.severity == FindingSeverity::Error);
            write(&report, color);
        }
        session.abandon();
        Ok(outcome)
    }
}

fn write(report: &CheckReport, color: Color) {
    to_stderr_in_color(color, |out| {
        format::write(ReportFormat::Human, report, &format::val3check::Template::default(), out)
    });
    report.unreadable.iter().for_each(|error| to_stderr(|out| writeln!(out, "{error}")));
    to_stderr(|out| summary::write(report, out));
}
