//! From files to an image: what the check finds, and what the compiler makes.

use std::sync::Arc;

use camino::Utf8PathBuf;
use val3_analysis::db::{Database, Project};
use val3_analysis::load::{self, Workspace};
use val3_bytecode::Image;
use val3_check::diagnostic::Diagnostic;
use val3_check::rule::Severity;
use val3_check::settings::{Selection, WorkspaceSettings};
use val3_compile::CompileError;

use super::Files;
use super::laid::Laid;

/// Reads the project of a project file, with these files laid over the disk.
///
/// # Errors
/// There is no such project, or a `val3.toml` is at fault.
pub(crate) fn load_laid(files: Files, manifest: &Utf8PathBuf) -> Result<(Workspace, Project), String> {
    let workspace = load::load(&Laid { files }, std::slice::from_ref(manifest)).map_err(|error| error.to_string())?;
    let [project] = *workspace.projects.as_slice() else {
        return Err(format!("`{manifest}` is no application or library"));
    };
    Ok((workspace, project))
}

/// The first error of a project among those that `counts`.
///
/// # Errors
/// The settings of the project are at fault.
pub(crate) fn first_error(
    db: &Database,
    project: Project,
    counts: impl Fn(&Diagnostic) -> bool,
) -> Result<Option<Diagnostic>, String> {
    let settings = WorkspaceSettings::new(db, &[project], &Selection::default())
        .map_err(|errors| errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))?;
    let units = val3_check::units(db, &[project]);
    let checked = units.iter().map(|unit| val3_check::check_unit(db, *unit, &settings)).sum();
    let findings = val3_check::finish(db, &units, &settings, checked).findings;
    Ok(findings.into_iter().find(|finding| finding.severity == Severity::Error && counts(finding)))
}

/// The image of a project without errors.
///
/// # Errors
/// A limit of the virtual controller that it exceeds.
pub(crate) fn compile(db: &Database, project: Project) -> Result<Arc<Image>, CompileError> {
    val3_compile::compile(db, project).map(Arc::new)
}
