//! The file with the things around the arm of an application, and the meshes that it names.

use std::sync::Arc;

use camino::Utf8Path;
use val3_cell::Mesh;
use val3_files::FileClass;

use super::Loader;
use super::outside::is_in_folder;
use crate::application::START;
use crate::db::{Configuration, File, MeshFile};
use crate::items::manifest::Manifest;
use crate::paths::{file_in, path_key};
use crate::surroundings::{FILE_NAME, mesh_names};
use crate::system::System;

impl Loader<'_> {
    /// Reads the `cell.toml` of the application in `folder`: the file that `[run] cell` names, the file beside
    /// `val3.toml`, or without one the file in the folder. `None` for libraries and user types, and for files outside of
    /// the folder of `val3.toml`.
    pub(super) fn surroundings(
        &mut self,
        folder: &Utf8Path,
        manifest: &Manifest,
        configuration: Option<Configuration>,
    ) -> Option<File> {
        let stem = |program: &str| file_in(folder, program).file_stem().map(str::to_owned);
        if !manifest.programs.iter().any(|program| stem(program).is_some_and(|stem| stem.eq_ignore_ascii_case(START))) {
            return None;
        }
        let settings = configuration.map(|configuration| configuration.file(&self.db));
        let (around, name) = match settings {
            Some(file) => (file.folder().to_owned(), file.config.run.cell.clone()),
            None => (folder.to_owned(), None),
        };
        if name.as_ref().is_some_and(|name| name == "none") {
            return None;
        }
        let path = around.join(name.as_deref().unwrap_or(Utf8Path::new(FILE_NAME)));
        let is_readable = self.is_listed(&path) && is_in_folder(self.system, &around, &path);
        if is_readable { self.found_file(&path) } else { None }
    }

    /// Reads the meshes that a `cell.toml` names, and the meshes of links that `[run] shapes` names. A mesh of an
    /// earlier load is read again only if it is stale.
    pub(super) fn meshes(&mut self, file: File, configuration: Option<Configuration>) -> Vec<MeshFile> {
        let folder = file.path(&self.db).parent().unwrap_or(Utf8Path::new("")).to_owned();
        let names = mesh_names(file.text(&self.db));
        let mut meshes: Vec<MeshFile> = names.iter().map(|name| self.mesh_below(&folder, name)).collect();
        let settings = configuration.map(|configuration| configuration.file(&self.db).clone());
        for settings in settings.iter() {
            let links = settings.config.run.shapes.values();
            meshes.extend(links.map(|link| self.mesh(settings.folder(), &link.file)));
        }
        meshes
    }

    /// Reads a mesh that has to be in the folder or below, also if `[run] shapes` may name the same file.
    fn mesh_below(&mut self, folder: &Utf8Path, name: &Utf8Path) -> MeshFile {
        match check_below(self.system, folder, name) {
            Ok(()) => self.mesh(folder, name),
            Err(reason) => MeshFile { path: folder.join(name), mesh: Err(reason) },
        }
    }

    fn mesh(&mut self, folder: &Utf8Path, name: &Utf8Path) -> MeshFile {
        let path = folder.join(name);
        let key = path_key(path.as_str());
        if let Some(known) = self.known.meshes.get(&key).filter(|_| !(self.is_stale)(&key)) {
            return known.clone();
        }
        let mesh = read_mesh(self.system, &path, name).map(Arc::new);
        let found = MeshFile { path, mesh };
        self.known.meshes.insert(key, found.clone());
        found
    }
}

/// Checks that a mesh is in the folder of a `cell.toml` or below.
fn check_below(system: &dyn System, folder: &Utf8Path, name: &Utf8Path) -> Result<(), String> {
    let is_below = name.is_relative() && !name.components().any(|part| part.as_str() == "..");
    let is_inside = is_below && system.target(&folder.join(name)).starts_with(system.target(folder));
    if is_inside { Ok(()) } else { Err(format!("`{name}` is not in the folder of this file")) }
}

fn read_mesh(system: &dyn System, path: &Utf8Path, name: &Utf8Path) -> Result<Mesh, String> {
    let bytes = system.read(path, FileClass::Shape).map_err(|reason| format!("cannot read `{name}`: {reason}"))?;
    Mesh::read(&bytes).map_err(|error| format!("cannot use `{name}`: {error}"))
}

/// Whether two versions of a `cell.toml` name the same meshes, so that the workspace need not be loaded again.
pub fn names_meshes_alike(before: &str, after: &str) -> bool {
    mesh_names(before) == mesh_names(after)
}
