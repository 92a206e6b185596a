//! Reading a workspace again after something changed.

use camino::Utf8PathBuf;
use val3_config::ConfigError;

use super::known::Known;
use super::{Loader, Workspace};
use crate::db::Database;
use crate::paths;
use crate::system::System;

impl Workspace {
    /// A workspace with nothing in it, to be refreshed.
    pub fn empty() -> Self {
        Self { db: Database::default(), projects: Vec::new(), unreadable: Vec::new() }
    }

    /// Finds the projects under `paths` as [`load`](super::load) does, and reads those files again of whose path keys
    /// `is_stale` holds. Inputs are kept, and set only where they differ, so that only what a change concerns is
    /// computed anew.
    ///
    /// Nothing keeps a workspace that is being edited from being read: what is at fault is left out, a configuration
    /// counts as it was before, and the faults of configurations are returned. A path without a project is none.
    pub fn refresh(
        &mut self,
        system: &dyn System,
        paths: &[Utf8PathBuf],
        is_stale: &dyn Fn(&str) -> bool,
    ) -> Vec<ConfigError> {
        let known = Known::of(&self.db);
        // A clone beside the loader's database would wait for itself at the first change.
        let db = std::mem::take(&mut self.db);
        let mut loader = Loader::new(db, system, known, is_stale);
        let found = paths.iter().filter_map(|path| loader.discover(&paths::normalise(path)).ok());
        let manifests = found.collect::<Vec<_>>().concat();
        let asked = loader.read(manifests);
        let errors = std::mem::take(&mut loader.config_errors);
        *self = loader.finish(&asked);
        errors
    }
}

#[cfg(test)]
mod tests;
