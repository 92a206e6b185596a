//! A folder as a controller: the files of the SRS emulator.

use camino::{Utf8Path, Utf8PathBuf};
use val3_files::{FileClass, FolderEntryKind, Unreadable, Unwritable};

use crate::access::{AccessError, AccessFault, ControllerFiles, ListedEntry};
use crate::path::{ControllerPath, NameFault, NameFaultKind};

/// Folder that contains `usr`.
#[derive(Debug)]
pub struct FolderFiles {
    folder: Utf8PathBuf,
}

impl FolderFiles {
    /// Opens a folder.
    ///
    /// # Errors
    /// If there is no such folder.
    pub fn open(folder: &Utf8Path) -> Result<Self, AccessError> {
        let files = Self { folder: folder.to_owned() };
        match folder.is_dir() {
            true => Ok(files),
            false => Err(files.error("open the folder".to_owned(), "there is no such folder".to_owned())),
        }
    }

    fn local(&self, path: &ControllerPath) -> Utf8PathBuf {
        self.folder.join(path.as_str())
    }

    fn error(&self, step: String, reason: String) -> AccessError {
        AccessError { step, place: self.folder.to_string(), reason: AccessFault::FileSystem(reason) }
    }

    fn written(&self, step: String, result: Result<(), Unwritable>) -> Result<(), AccessError> {
        result.map_err(|reason| self.error(step, reason.to_string()))
    }
}

impl ControllerFiles for FolderFiles {
    fn place(&self) -> &str {
        self.folder.as_str()
    }

    fn list(&mut self, folder: &ControllerPath) -> Result<Vec<ListedEntry>, AccessError> {
        let step = format!("list `{folder}`");
        let entries = val3_files::list_folder(&self.local(folder));
        let fault = |reason| AccessError { step: step.clone(), place: self.folder.to_string(), reason };
        let entries = entries.map_err(|reason| match reason {
            Unreadable::NameNotUtf8(name) => {
                fault(AccessFault::Name(NameFault { name, reason: NameFaultKind::NotUtf8 }))
            }
            reason => fault(AccessFault::FileSystem(reason.to_string())),
        })?;
        let entries = entries.into_iter().map(|entry| {
            let path = folder.child(&entry.name).map_err(|reason| fault(AccessFault::Name(reason)))?;
            match entry.kind {
                FolderEntryKind::File => Ok(ListedEntry { path, is_folder: false }),
                FolderEntryKind::Folder => Ok(ListedEntry { path, is_folder: true }),
                FolderEntryKind::Special => Err(fault(AccessFault::Special(entry.name))),
            }
        });
        entries.collect()
    }

    fn read(&mut self, file: &ControllerPath, limit: u64) -> Result<Vec<u8>, AccessError> {
        let step = format!("read `{file}`");
        match val3_files::read(&self.local(file), FileClass::Program) {
            Ok(bytes) if bytes.len() as u64 <= limit => Ok(bytes),
            Ok(_) => Err(AccessError { step, place: self.folder.to_string(), reason: AccessFault::TooLarge(limit) }),
            Err(Unreadable::TooLarge { limit, .. }) => {
                Err(AccessError { step, place: self.folder.to_string(), reason: AccessFault::TooLarge(limit) })
            }
            Err(reason) => Err(self.error(step, reason.to_string())),
        }
    }

    fn write(&mut self, file: &ControllerPath, bytes: &[u8]) -> Result<(), AccessError> {
        // The recovery of a killed push removes the temporary files of the push only, so a write creates no others.
        self.written(format!("write `{file}`"), val3_files::write_directly(&self.local(file), bytes))
    }

    fn rename(&mut self, from: &ControllerPath, to: &ControllerPath) -> Result<(), AccessError> {
        let renamed = val3_files::rename_file(&self.local(from), &self.local(to));
        self.written(format!("rename `{from}` to `{}`", to.name()), renamed)
    }

    fn remove(&mut self, file: &ControllerPath) -> Result<(), AccessError> {
        self.written(format!("remove `{file}`"), val3_files::remove_file(&self.local(file)))
    }

    fn make_folder(&mut self, folder: &ControllerPath) -> Result<(), AccessError> {
        self.written(format!("create the folder `{folder}`"), val3_files::create_folder(&self.local(folder)))
    }

    fn remove_folder(&mut self, folder: &ControllerPath) -> Result<(), AccessError> {
        self.written(format!("remove the folder `{folder}`"), val3_files::remove_folder(&self.local(folder)))
    }

    fn reconnect(&mut self) -> Result<(), AccessError> {
        Self::open(&self.folder).map(|_| ())
    }
}
