//! Runs the lints.

use val3_analysis::db::{Db, File, Project};

use super::{DataFile, Findings, Program, ProjectView};
use crate::diagnostic::Diagnostic;
use crate::rule::Lint;
use crate::rules;
use crate::settings::Settings;

/// What the lints find in the program in `file`.
pub(crate) fn program(db: &dyn Db, project: Project, file: File, settings: &Settings) -> Vec<Diagnostic> {
    let program = Program::new(db, project, file, &settings.options);
    let mut found = Findings::new(file, Some(program.name().to_owned()), project.manifest(db));
    for lint in lints(settings) {
        if let Lint::Program(check) = lint {
            check(&program, &mut found);
        }
    }
    found.into_diagnostics()
}

/// What they find in the data in `file`.
pub(crate) fn data(db: &dyn Db, project: Project, file: File, settings: &Settings) -> Vec<Diagnostic> {
    let data = DataFile::new(db, project, file, &settings.options);
    let mut found = Findings::new(file, None, project.manifest(db));
    for lint in lints(settings) {
        if let Lint::Data(check) = lint {
            check(&data, &mut found);
        }
    }
    found.into_diagnostics()
}

/// What they find in the project file of `project`.
pub(crate) fn project(db: &dyn Db, project: Project, settings: &Settings) -> Vec<Diagnostic> {
    let view = ProjectView::new(db, project, &settings.options);
    let file = project.manifest(db);
    let mut found = Findings::new(file, None, file);
    for lint in lints(settings) {
        if let Lint::Project(check) = lint {
            check(&view, &mut found);
        }
    }
    found.into_diagnostics()
}

/// The lints that are asked for.
fn lints(settings: &Settings) -> impl Iterator<Item = Lint> {
    rules::all().iter().filter(|rule| settings.wants(rule)).filter_map(|rule| rule.lint)
}
