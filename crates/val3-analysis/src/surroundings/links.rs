//! Meshes of the arm's links, which `[run] shapes` of a `val3.toml` names.

use camino::Utf8Path;
use val3_cell::{LinkFile, LinkHull, Mesh, check_link_names, link_names};
use val3_config::{ConfigError, ConfigFile, LengthUnit};

use crate::arm::arm;
use crate::db::{Db, Project};

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
    check_link_names(shapes.keys(), arm.model.axes())
        .map_err(|error| file.fault(&error.key, error.message, error.help))?;
    let hull = |(link, name): (usize, String)| {
        let Some(shape) = shapes.get(&name) else { return Ok(None) };
        let unit = shape.unit.map(LengthUnit::length);
        let of = LinkFile { path: &shape.file, unit, origin_at_zero: shape.origin_at_zero };
        let mesh = mesh(db, project, file, of.path).map_err(Into::into);
        let hull = mesh.and_then(|mesh| of.hull(mesh, &arm.model, link));
        hull.map(Some).map_err(|error| file.fault(&format!("run.shapes.{name}"), error.message, error.help))
    };
    link_names(arm.model.axes()).enumerate().map(hull).collect()
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
