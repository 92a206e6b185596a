//! Meshes of the arm's links, which `[run] shapes` of a `val3.toml` names.

use camino::Utf8Path;
use val3_cell::{LinkError, LinkFile, LinkHull, Mesh, check_link_names, link_names};
use val3_config::{ConfigError, ConfigFile, LengthUnit, LinkShapeFile};
use val3_kinematics::Arm;

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
    let meshes = LinkMeshes { db, project, file };
    let mut hulls = Vec::new();
    for (link, name) in link_names(arm.model.axes()).enumerate() {
        let hull = shapes.get(&name).map(|shape| meshes.hull(shape, &arm.model, link)).transpose();
        hulls.push(hull.map_err(|error| file.fault(&format!("run.shapes.{name}"), error.message, error.help))?);
    }
    Ok(hulls)
}

/// Meshes that the `val3.toml` of an application names.
struct LinkMeshes<'m> {
    db: &'m dyn Db,
    project: Project,
    file: &'m ConfigFile,
}

impl LinkMeshes<'_> {
    /// Returns the hull of the mesh that the settings name for the base (0) or a link.
    fn hull(&self, shape: &LinkShapeFile, arm: &Arm, link: usize) -> Result<LinkHull, LinkError> {
        let unit = shape.unit.map(LengthUnit::length);
        let file = LinkFile { path: &shape.file, unit, origin_at_zero: shape.origin_at_zero };
        file.hull(self.mesh(file.path)?, arm, link)
    }

    fn mesh(&self, path: &Utf8Path) -> Result<Mesh, String> {
        let full = self.file.folder().join(path);
        // The meshes of links follow those of `cell.toml`, which may not name the same file.
        let mesh = self.project.meshes(self.db).iter().rfind(|mesh| mesh.path == full);
        mesh.map_or_else(
            || Err(format!("`{path}` has not been read")),
            |found| found.mesh.as_deref().cloned().map_err(String::clone),
        )
    }
}
