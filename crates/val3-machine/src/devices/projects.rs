//! Projects on the medium with the applications, and their data files, as clients outside read them.

use val3_vm::{InstanceId, Space};

use super::Devices;
use super::outside::controller_path;
use super::saving::Saving;
use crate::files::{ControllerPath, FileFault, LibraryFiles, LibraryPath, list};

/// Medium with the applications.
const DISK: &str = "Disk";

impl Devices {
    /// Lists the projects in the folders directly on `Disk`, without encrypted archives. A missing medium has none.
    ///
    /// # Errors
    /// The medium cannot be read.
    pub fn projects(&mut self) -> Result<Vec<LibraryPath>, FileFault> {
        let disk = ControllerPath::root(DISK);
        self.outside.ask(|media| {
            let names = match list(&media.roots, &disk) {
                Err(FileFault::BadPath | FileFault::NotFound) => Vec::new(),
                names => names?,
            };
            let folders = names.iter().map(|name| disk.child(name)).filter(|folder| !folder.has_extension("zip"));
            let projects = folders.filter_map(|folder| LibraryPath::new(&folder).ok());
            Ok(projects.filter(|project| project.exists(&media.roots).unwrap_or(false)).collect())
        })
    }

    /// Data file of an application or library in memory, with the current values.
    ///
    /// # Errors
    /// The project is encrypted or has no data file, or the data exceed the limit of `libSave`.
    pub fn current_data_file(&self, space: &Space, instance: InstanceId) -> Result<Vec<u8>, FileFault> {
        let (io, lines, limit) = (&self.state.io, &self.lines, self.limits.saved);
        let saving = Saving { space, from: instance, saved: instance, io, lines, limit };
        data_file(saving.current(&self.state.loaded)?)
    }

    /// Data file of a project on a medium.
    ///
    /// # Errors
    /// The project does not exist or cannot be read, is encrypted or has no data file.
    pub fn stored_data_file(&mut self, path: &str) -> Result<Vec<u8>, FileFault> {
        let project = LibraryPath::new(&controller_path("", path)?)?;
        data_file(self.outside.ask(|media| project.read(&media.roots, ""))?)
    }
}

/// The first data file of a project.
fn data_file(files: LibraryFiles) -> Result<Vec<u8>, FileFault> {
    if files.encrypted {
        return Err(FileFault::ReadOnly);
    }
    let mut files = files.files.into_iter();
    let data = files.find(|file| file.path.extension().is_some_and(|found| found.eq_ignore_ascii_case("dtx")));
    data.map(|file| file.bytes).ok_or(FileFault::NotFound)
}
