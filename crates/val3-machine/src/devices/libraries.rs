//! Libraries on the media (6.6, 6.7).

use val3_vm::LoadedLibrary;

use super::Devices;
use super::media::controller_path;
use crate::controller_state::Severity;
use crate::files::{FileFault, LibraryPath};

impl Devices {
    /// Finds and compiles the library that a program of `from` names.
    pub(super) fn find_library(&mut self, from: &str, path: &str, password: &str) -> Result<LoadedLibrary, FileFault> {
        let path = controller_path(from, path)?;
        let library = LibraryPath::new(&self.outside.ask(|media| media.roots.spelled(&path))?)?;
        self.access(0);
        let files = self.outside.ask(|media| library.read(&media.roots, password))?;
        self.access(files.size());
        let image =
            self.outside.ask(|media| media.libraries.image(library.folder(), files.clone())).map_err(|reason| {
                self.report_here(&reason, Severity::Error);
                FileFault::CannotLoad
            })?;
        self.state.loaded.keep_read(&image, files);
        Ok(LoadedLibrary { image, path: library.path().to_string() })
    }
}
