//! Projects on the medium with the applications, their files and values, as clients outside read them.

use std::sync::Arc;

use val3_lang::ports::TaskNumber;
use val3_vm::{InstanceId, Space, Vm};

use super::Devices;
use super::loaded::ReplacedLines;
use super::saving::{self, DataSelection, DocumentFault, Saving};
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
    /// The project is encrypted or has no data file, or `libSave` could not save the data.
    pub fn current_data_file(&self, space: &Space, instance: InstanceId) -> Result<Vec<u8>, FileFault> {
        data_file(self.current_files(space, instance)?)
    }

    /// Files of an application or library in memory as they were loaded, with the current values.
    ///
    /// # Errors
    /// `libSave` could not save the data.
    pub fn current_files(&self, space: &Space, instance: InstanceId) -> Result<LibraryFiles, FileFault> {
        Ok(self.saving(space, instance).current(&self.state.loaded)?)
    }

    /// Parameters and locals of a task's stack frame as a data file. `depth` 0 is the innermost frame.
    ///
    /// # Errors
    /// There is no such frame, or its values are too large.
    pub fn frame_document(&self, vm: &mut Vm, task: TaskNumber, depth: usize) -> Result<String, DocumentFault> {
        let found = vm.tasks().iter().find(|known| known.id == task);
        let frame = found.and_then(|task| task.thread.frames.iter().rev().nth(depth)).copied();
        let frame = frame.ok_or(DocumentFault::NoFrame)?;
        let written =
            vm.with_stack_in_space(task, |space| saving::frame_document(&self.saving(space, frame.instance), &frame));
        written.ok_or(DocumentFault::NoFrame)?
    }

    /// Selected data as a data file. For one value of an array, the file has the sizes of the array.
    ///
    /// # Errors
    /// An application has no such data or value, or the values are too large.
    pub fn data_document(&self, space: &Space, selections: &[DataSelection]) -> Result<String, DocumentFault> {
        saving::data_document(selections, |instance| self.saving(space, instance))
    }

    fn saving<'s>(&'s self, space: &'s Space, instance: InstanceId) -> Saving<'s> {
        let (io, lines, limit) = (&self.state.io, &self.lines, self.limits.saved);
        Saving { space, from: instance, saved: instance, io, lines, limit }
    }

    /// Returns the loaded files of the instance; `None` if the files could not be read.
    pub(crate) fn loaded_files(&self, instance: InstanceId) -> Option<Arc<LibraryFiles>> {
        self.state.loaded.files(instance.0)
    }

    /// Stores the files of an instance that is loaded once more.
    pub(crate) fn keep_loaded_files(&mut self, instance: InstanceId, files: Option<Arc<LibraryFiles>>) {
        if let Some(files) = files {
            self.state.loaded.keep_shared_files(instance.0, files);
        }
    }

    /// Replaced lines of an instance, which differ from its files: the code, by file and row.
    #[must_use]
    pub fn replaced_lines(&self, InstanceId(instance): InstanceId) -> ReplacedLines {
        self.state.loaded.replaced(instance).cloned().unwrap_or_default()
    }

    /// Stores the replaced lines of an instance whose image was exchanged for them.
    pub(crate) fn keep_replaced_lines(&mut self, InstanceId(instance): InstanceId, lines: ReplacedLines) {
        self.state.loaded.keep_replaced(instance, lines);
    }

    /// Data file of a project on a medium.
    ///
    /// # Errors
    /// The project does not exist or cannot be read, is encrypted or has no data file.
    pub fn stored_data_file(&mut self, path: &str) -> Result<Vec<u8>, FileFault> {
        data_file(self.stored_files(path)?)
    }

    /// Files of a project on a medium.
    ///
    /// # Errors
    /// The project does not exist or cannot be read.
    pub fn stored_files(&mut self, path: &str) -> Result<LibraryFiles, FileFault> {
        self.outside.files(path)
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
