//! An application of the workspace, as its `cell.toml` refers to it.

use camino::Utf8Path;
use val3_cell::{ArmBase, Cell, CellError, CellFile, DataKind, KnownSignal, Mesh, Surroundings};
use val3_config::TableFile;
use val3_lang::suggest::nearest;
use val3_lang::types::BaseType;

use super::path_type;
use super::signals::Signals;
use crate::arm::arm;
use crate::db::{Db, Project};
use crate::items::positions::positions;
use crate::items::project::data_files;
use crate::placement::shown;

/// Builds the cell around the arm of an application. `is_named` states whether a setting names the file; otherwise the
/// file can be about another application, and things in unknown frames and tools are omitted.
///
/// # Errors
/// A name, a carrier, a shape, a signal, or a mesh cannot be used.
pub(super) fn build(
    db: &dyn Db,
    project: Project,
    table: &TableFile<CellFile>,
    is_named: bool,
) -> Result<Cell, CellError> {
    // Without a known arm, its configuration has an error, which is reported there.
    let base = arm(db, project)
        .as_ref()
        .map_or(ArmBase { axes: 6, height: 0.0 }, |arm| ArmBase { axes: arm.model.axes(), height: arm.model.height() });
    let mut application = LoadedApplication { db, project, signals: Signals::of(db, project), is_named };
    Cell::build(&table.content, base, &mut application)
}

/// Whether a setting names the `cell.toml` of an application.
pub(super) fn is_named(db: &dyn Db, project: Project) -> bool {
    project.config(db).is_some_and(|config| config.run.cell.is_some())
}

struct LoadedApplication<'a> {
    db: &'a dyn Db,
    project: Project,
    signals: Signals,
    is_named: bool,
}

impl LoadedApplication<'_> {
    /// Data paths of the frames and tools, as programs write them.
    fn carriers(&self) -> Vec<String> {
        let files = data_files(self.db, self.project).iter();
        let carriers = files
            .flat_map(|file| positions(self.db, *file))
            .filter(|(_, position)| matches!(position.ty, BaseType::Frame | BaseType::Tool))
            .map(|(path, _)| shown(path));
        let mut carriers: Vec<String> = carriers.collect();
        carriers.sort_unstable();
        carriers
    }
}

impl Surroundings for LoadedApplication<'_> {
    fn mesh(&mut self, path: &Utf8Path) -> Result<Mesh, String> {
        let folder = self.project.surroundings(self.db).and_then(|file| file.path(self.db).parent());
        let full = folder.unwrap_or(Utf8Path::new("")).join(path);
        let mesh = self.project.meshes(self.db).iter().find(|mesh| mesh.path == full);
        match mesh.map(|mesh| &mesh.mesh) {
            Some(mesh) => mesh.as_ref().map(|mesh| Mesh::clone(mesh)).map_err(String::clone),
            None => Err(format!("`{path}` has not been read")),
        }
    }

    fn carrier(&self, name: &str) -> Result<DataKind, Option<String>> {
        match path_type(self.db, self.project, name) {
            Some(BaseType::Frame) => Ok(DataKind::Frame),
            Some(BaseType::Tool) => Ok(DataKind::Tool),
            _ => Err(nearest(name, self.carriers().iter().map(String::as_str)).map(str::to_owned)),
        }
    }

    fn signal(&self, path: &str) -> Result<KnownSignal, Option<String>> {
        self.signals.find(path)
    }

    fn may_lack_data(&self) -> bool {
        !self.is_named
    }
}
