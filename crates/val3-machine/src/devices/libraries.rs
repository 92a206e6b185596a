//! Libraries on the media (6.6, 6.7).

use std::sync::Arc;

use val3_vm::Loaded;

use super::Devices;
use super::media::controller_path;
use crate::controller_state::Severity;
use crate::files::{FileFault, LibraryPath};

impl Devices {
    /// Finds and compiles the library that a program of `from` names.
    pub(super) fn find_library(&mut self, from: &str, path: &str, password: &str) -> Result<Loaded, FileFault> {
        let library = LibraryPath::new(&self.roots.spelled(&controller_path(from, path)?)?)?;
        self.access(0);
        let files = library.read(&self.roots, password)?;
        self.access(files.size());
        let image = self.libraries.image(library.folder(), files.clone()).map_err(|reason| {
            self.log.report(&reason, Severity::Error, self.origin.time);
            self.record_log();
            FileFault::CannotLoad
        })?;
        self.read = Some((Arc::clone(&image), files));
        Ok(Loaded { image, path: library.path().to_string() })
    }
}
