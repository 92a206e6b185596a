//! Meshes of the arm's links, which `[run] shapes` of a `val3.toml` names.

use camino::Utf8Path;
use val3_cell::{LinkHull, Mesh, link_names};
use val3_config::{ConfigError, ConfigFile};

use crate::arm::arm;
use crate::db::{Db, Project};

/// Advice for a mesh that cannot be used.
const HELP: &str = "name a mesh of the link, or remove the setting: the capsules of the arm are then compared";

/// Returns the hulls of the base and the links of an application's arm; `None` for a link without a mesh.
///
/// # Errors
/// The arm has no such link, or a file cannot be used.
pub(super) fn hulls(db: &dyn Db, project: Project) -> Result<Vec<Option<LinkHull>>, ConfigError> {
    let Some(file) = project.configuration(db).map(|configuration| configuration.file(db)) else {
        return Ok(Vec::new());
    };
    // An arm that is not known is reported elsewhere.
    let Ok(arm) = arm(db, project) else { return Ok(Vec::new()) };
    let shapes = &file.config.run.shapes;
    let names: Vec<String> = link_names(arm.model.axes()).collect();
    if let Some(name) = shapes.keys().find(|name| !names.contains(name)) {
        let help = format!("its parts are `base` and `link1` to `link{}`", arm.model.axes());
        return Err(file.fault(&format!("run.shapes.{name}"), format!("the arm has no `{name}`"), help));
    }
    let hull = |name: &String| {
        let Some(path) = shapes.get(name) else { return Ok(None) };
        let hull = mesh(db, project, file, path).and_then(|mesh| LinkHull::new(path, mesh));
        hull.map(Some).map_err(|message| file.fault(&format!("run.shapes.{name}"), message, HELP.to_owned()))
    };
    names.iter().map(hull).collect()
}

fn mesh(db: &dyn Db, project: Project, file: &ConfigFile, path: &Utf8Path) -> Result<Mesh, String> {
    let full = file.folder().join(path);
    // The meshes of links follow those of `cell.toml`, which may not name the same file.
    let mesh = project.meshes(db).iter().rfind(|mesh| mesh.path == full);
    mesh.map_or_else(
        || Err(format!("`{path}` has not been read")),
        |found| found.mesh.as_deref().cloned().map_err(String::clone),
    )
}
