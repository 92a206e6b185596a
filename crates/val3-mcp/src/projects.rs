//! Projects in the roots.

use camino::{Utf8Path, Utf8PathBuf};
use smol_str::SmolStr;
use val3_analysis::db::{Database, Project};
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::System;
use val3_lang::suggest::{proposals, question};

use crate::refusal::Refusal;
use crate::roots::Roots;

/// Reads the projects below a path.
///
/// # Errors
/// The path does not exist, or contains no project.
pub(crate) fn read(system: &dyn System, roots: &Roots, path: &Utf8Path) -> Result<Workspace, Refusal> {
    load(system, &[path.to_owned()]).map_err(|error| Refusal(error.to_string().replace(roots.first().as_str(), ".")))
}

/// Returns the project for a path: the only project below it, or the project with this folder, `.pjx` or file.
///
/// # Errors
///
/// No project matches, or several do.
pub(crate) fn only(workspace: &Workspace, roots: &Roots, path: &Utf8Path) -> Result<Project, Refusal> {
    let Workspace { db, projects, .. } = workspace;
    let folder = |project: &Project| project.manifest(db).path(db).parent().unwrap_or(Utf8Path::new("")).to_owned();
    let is_here = |project: &&Project| folder(project) == path || project.manifest(db).path(db) == path;
    let at = projects
        .iter()
        .find(is_here)
        .or_else(|| projects.iter().find(|project| Some(&*folder(project)) == path.parent()));
    let only = match projects.as_slice() {
        [project] => Some(project),
        _ => None,
    };
    at.or(only).copied().ok_or_else(|| {
        let folders: Vec<String> =
            projects.iter().map(|project| format!("`{}`", roots.shown(&folder(project)))).collect();
        Refusal(format!("`{}` has {} projects: name one of {}", roots.shown(path), folders.len(), folders.join(", ")))
    })
}

/// Folder of a project.
pub(crate) fn folder(db: &Database, project: Project) -> Utf8PathBuf {
    val3_analysis::items::project::folder(db, project).to_owned()
}

/// Error for an unknown name, with similar names. `what` is the kind of the named item.
pub(crate) fn unknown<'n>(what: &str, name: &str, names: impl IntoIterator<Item = &'n SmolStr>) -> Refusal {
    let names: Vec<&str> = names.into_iter().map(SmolStr::as_str).collect();
    let hint = question(proposals(name, names)).unwrap_or_else(|| "`outline` lists all names".to_owned());
    Refusal(format!("there is no {what} `{name}`: {hint}"))
}
