//! Check of the files that the controller will have after a push.

use camino::Utf8PathBuf;
use val3_check::settings::RuleSelection;
use val3_controller::{ControllerPath, ControllerProject, ProjectStatus, PushPlan, remove_new_tree, write_new_tree};

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
    if !plan.new_files(status).any(|path| path.is_in(&applications) && path.is_project()) {
        note("note: nothing was checked, because the controller has no application");
        return Ok(CheckOutcome::Clean);
    }
    // Settings count too: the check compares applications with inputs, outputs and lines.
    if plan.unselected.is_empty() {
        return check(project.local(&applications), selection, color);
    }
    let folder = write_new_tree(project, status, plan)?;
    let outcome = check(folder.join(applications.as_str()), selection, color);
    remove_new_tree(project)?;
    outcome
}

fn check(folder: Utf8PathBuf, selection: RuleSelection, color: Color) -> Result<CheckOutcome, UserError> {
    let request = OpenRequest { asked: vec![folder], selection, ..OpenRequest::default() };
    let mut session = Session::open(&request)?;
    let found = session.check()?;
    let mut report = session.report(found);
    let outcome = match report.is_complete() && !report.reaches(FindingSeverity::Error) {
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

fn write(report: &CheckReport, color: Color) {
    to_stderr_in_color(color, |out| {
        format::write(ReportFormat::Human, report, &format::val3check::Template::default(), out)
    });
    report.unreadable.iter().for_each(|error| to_stderr(|out| writeln!(out, "{error}")));
    to_stderr(|out| summary::write(report, out));
}
