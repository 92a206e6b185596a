//! The cell around the arm of an application, for checks of positions and moves.

use std::sync::Arc;

use val3_cell::{CellFile, Scene};
use val3_config::TableFile;

use super::links::hulls;
use super::loaded::{build, is_named};
use crate::arm::arm;
use crate::db::{Db, Project};

/// A scene that queries share. Two scenes are equal if they are the same.
#[derive(Debug, Clone)]
pub struct SharedScene(Arc<Scene>);

impl SharedScene {
    /// The scene.
    pub fn scene(&self) -> &Arc<Scene> {
        &self.0
    }
}

impl PartialEq for SharedScene {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// Returns the cell around the arm of an application; `None` without a `cell.toml`, and if the file, the arm or a mesh
/// of a link has faults, which are reported there.
#[salsa::tracked]
pub fn scene(db: &dyn Db, project: Project) -> Option<SharedScene> {
    let file = project.surroundings(db)?;
    let arm = arm(db, project).as_ref().ok()?;
    let table = TableFile::<CellFile>::parse(file.path(db), file.text(db)).ok()?;
    let cell = build(db, project, &table, is_named(db, project)).ok()?;
    let cell = cell.with_links(hulls(db, project).ok()?);
    Some(SharedScene(Arc::new(Scene::new(Arc::new(cell), Arc::clone(&arm.model)))))
}
