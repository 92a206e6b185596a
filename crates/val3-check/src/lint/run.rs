//! Runs the lints.

use val3_analysis::db::{Db, File, Project};

use super::{DataFile, Findings, ProgramView, ProjectView};
use crate::diagnostic::Diagnostic;
use crate::rule::{Lint, Rule, Severity};
use crate::rules::{self, instruction_version, other_version, overrun_not_global, task_local_by_reference};
use crate::settings::Settings;

type ProgramLint = fn(&ProgramView<'_>, &mut Findings);

/// Findings of the lints that read a single program.
pub(crate) fn program(program: &ProgramView<'_>, settings: &Settings) -> Vec<Diagnostic> {
    of_program(program, settings, |lint| if let Lint::Program(check) = lint { Some(check) } else { None })
}

/// Findings in a program of the lints that read its whole application.
pub(crate) fn member(program: &ProgramView<'_>, settings: &Settings) -> Vec<Diagnostic> {
    of_program(program, settings, |lint| if let Lint::Member(check) = lint { Some(check) } else { None })
}

fn of_program(
    program: &ProgramView<'_>,
    settings: &Settings,
    kind: fn(Lint) -> Option<ProgramLint>,
) -> Vec<Diagnostic> {
    let application = program.project.manifest(program.db);
    let mut found = Findings::new(program.file, Some(program.name().to_owned()), application);
    wanted(settings, kind).for_each(|check| check(program, &mut found));
    let mut diagnostics = found.into_diagnostics();
    remove_errors_of_skipped_lines(program, &mut diagnostics);
    diagnostics
}

/// Lints whose errors are reported by the controller's compiler, and therefore also in lines that are never executed.
const REJECTED: [&Rule; 2] = [&overrun_not_global::RULE, &task_local_by_reference::RULE];

/// Removes run-time errors in lines that constant conditions or a `return` keep from being executed, such as the block
/// of `if false`.
fn remove_errors_of_skipped_lines(program: &ProgramView<'_>, diagnostics: &mut Vec<Diagnostic>) {
    let is_runtime_error = |found: &Diagnostic| found.severity == Severity::Error && !REJECTED.contains(&found.rule);
    if diagnostics.iter().any(is_runtime_error) {
        let skipped: Vec<_> = program.guards().never_evaluated(program.body).collect();
        let is_skipped = |range| skipped.iter().any(|skipped| skipped.contains_range(range));
        diagnostics.retain(|found| !(is_runtime_error(found) && is_skipped(found.place.range)));
    }
}

/// Instructions of a program that its declared version, or the version to which it is moved, does not have. They are
/// also reported in programs with faults.
pub(crate) fn versions(program: &ProgramView<'_>, settings: &Settings) -> Vec<Diagnostic> {
    let application = program.project.manifest(program.db);
    let mut found = Findings::new(program.file, Some(program.name().to_owned()), application);
    if settings.is_enabled(&instruction_version::RULE) {
        instruction_version::check(program, &mut found);
    }
    if settings.is_enabled(&other_version::RULE) {
        other_version::check(program, &mut found);
    }
    found.into_diagnostics()
}

/// Findings in the data of `file`.
pub(crate) fn data(db: &dyn Db, project: Project, file: File, settings: &Settings) -> Vec<Diagnostic> {
    let data = DataFile::new(db, project, file, &settings.options);
    let mut found = Findings::new(file, None, project.manifest(db));
    for check in wanted(settings, |lint| if let Lint::Data(check) = lint { Some(check) } else { None }) {
        check(&data, &mut found);
    }
    found.into_diagnostics()
}

/// Findings in the project file of `project`.
pub(crate) fn project(db: &dyn Db, project: Project, settings: &Settings) -> Vec<Diagnostic> {
    let view = ProjectView::new(db, project, &settings.options);
    let file = project.manifest(db);
    let mut found = Findings::new(file, None, file);
    for check in wanted(settings, |lint| if let Lint::Project(check) = lint { Some(check) } else { None }) {
        check(&view, &mut found);
    }
    found.into_diagnostics()
}

/// Lints of a kind that are on.
fn wanted<C>(settings: &Settings, kind: fn(Lint) -> Option<C>) -> impl Iterator<Item = C> {
    rules::all().iter().filter_map(move |rule| rule.lint.and_then(kind).filter(|_| settings.is_enabled(rule)))
}
