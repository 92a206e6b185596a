//! Repeated loading of a workspace after a change.

use camino::Utf8PathBuf;
use val3_config::ConfigError;

use super::known_inputs::KnownInputs;
use super::{Loader, Workspace};
use crate::db::Database;
use crate::paths;
use crate::system::System;

impl Workspace {
    /// Creates an empty workspace, to be refreshed.
    pub fn empty() -> Self {
        Self { db: Database::default(), projects: Vec::new(), unreadable: Vec::new() }
    }

    /// Finds the projects under `paths` like [`load`](super::load), and reads the files whose path keys are `is_stale`
    /// once more. Inputs are reused, and set only if they differ, so that only affected queries run again.
    ///
    /// A fault does not stop the load: faulty parts are omitted, a faulty configuration keeps its previous content, and
    /// the configuration errors are returned. A path without a project is no error.
    pub fn refresh(
        &mut self,
        system: &dyn System,
        paths: &[Utf8PathBuf],
        is_stale: &dyn Fn(&str) -> bool,
    ) -> Vec<ConfigError> {
        let known = KnownInputs::of(&self.db);
        // Moved instead of cloned: salsa blocks a change until all clones are dropped, so a clone would deadlock.
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
