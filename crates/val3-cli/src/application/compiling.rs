//! From files to an image: what the check finds, and what the compiler makes.

use std::sync::Arc;

use camino::Utf8PathBuf;
use val3_analysis::db::{Database, Project};
use val3_analysis::load::{self, Workspace};
use val3_bytecode::Image;
use val3_check::diagnostic::Diagnostic;
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

/// The first reason among those that `counts` why the controller's compiler refuses a project.
pub(crate) fn first_refusal(
    db: &Database,
    project: Project,
    counts: impl Fn(&Diagnostic) -> bool,
) -> Option<Diagnostic> {
    val3_check::refusals(db, project).into_iter().find(counts)
}

/// The image of a project that the controller's compiler does not refuse.
///
/// # Errors
/// A limit of the virtual controller that it exceeds.
pub(crate) fn compile(db: &Database, project: Project) -> Result<Arc<Image>, CompileError> {
    val3_compile::compile(db, project).map(Arc::new)
}
