//! Libraries on the media (6.6, 6.7).

use val3_vm::Loaded;

use super::Devices;
use crate::controller_state::Severity;
use crate::event::What;
use crate::files::{ControllerPath, FileFault, LibraryPath};

impl Devices {
    /// Finds and compiles the library that a program of `from` names.
    pub(super) fn load_library(&mut self, from: &str, path: &str, password: &str) -> Result<Loaded, u16> {
        let loaded = self.find_library(from, path, password);
        let code = loaded.as_ref().err().map_or(0, |fault| fault.code());
        self.record(What::Lib { op: "load", alias: String::new(), path: path.to_owned(), code });
        loaded.map_err(FileFault::code)
    }

    fn find_library(&mut self, from: &str, path: &str, password: &str) -> Result<Loaded, FileFault> {
        let application = ControllerPath::parse(from, &ControllerPath::root("Disk"))?;
        let library = LibraryPath::new(&ControllerPath::parse(path, &application)?)?;
        let files = library.read(&self.roots, password)?;
        let image = self.libraries.image(library.folder(), files).map_err(|reason| {
            let now = self.origin.time;
            self.log.report(&reason, Severity::Error, now);
            FileFault::CannotLoad
        })?;
        Ok(Loaded { image, path: library.folder().to_string() })
    }
}
