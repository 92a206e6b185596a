//! Files of a controller at an address. Nothing is written, neither here nor on the controller.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use camino::Utf8Path;
use val3_backup::{BackupFile, BackupFiles};
use val3_controller::{ControllerFiles, ControllerPath, TOTAL_LIMIT, files_below, read_files};

use super::OpenedBackup;
use crate::controller::{ProgressObserver, connect, parse_address};
use crate::user_error::UserError;

/// Folders of a controller that a command reads.
pub(crate) struct RemoteFolders {
    /// Folders whose files are all downloaded, so that their sizes are known.
    pub(crate) downloaded: &'static [&'static str],
    /// Folders that are listed. Their files are downloaded when they are read.
    pub(crate) listed: &'static [&'static str],
}

/// Opens the controller at an address. Folders that it does not have are omitted.
///
/// # Errors
/// The address is wrong, the controller cannot be reached, or a folder or file cannot be read.
pub(crate) fn open_address(address: &Utf8Path, folders: &RemoteFolders) -> Result<OpenedBackup, UserError> {
    let address = parse_address(address.as_str())?;
    let mut controller = connect(&address)?;
    let mut observer = ProgressObserver::default();
    let contents = read_files(&mut *controller, &paths(folders.downloaded)?, &mut observer)?;
    let listed = files_below(&mut *controller, &paths(folders.listed)?, &mut observer)?;
    observer.end();
    let contents: BTreeMap<String, Vec<u8>> = contents.into_iter().map(|(path, bytes)| (path.into(), bytes)).collect();
    let names: BTreeSet<String> = listed.into_iter().map(String::from).chain(contents.keys().cloned()).collect();
    let size = |path: &str| contents.get(path).map_or(0, |bytes| bytes.len().try_into().unwrap_or(u64::MAX));
    // The clock of a controller is not reliable, so that files have no dates.
    let files = names.into_iter().map(|path| BackupFile { size: size(&path), path, modified: None }).collect();
    let files = RemoteFiles { files, contents: RefCell::new(contents), controller: RefCell::new(controller) };
    Ok(OpenedBackup { files: Box::new(files), root: address.to_string().into(), unread: Vec::new() })
}

fn paths(folders: &[&str]) -> Result<Vec<ControllerPath>, UserError> {
    let path = |text: &&str| ControllerPath::parse(text).map_err(|fault| UserError::new(fault.to_string()));
    folders.iter().map(path).collect()
}

/// Files on a controller.
struct RemoteFiles {
    files: Vec<BackupFile>,
    /// Downloaded files by path.
    contents: RefCell<BTreeMap<String, Vec<u8>>>,
    controller: RefCell<Box<dyn ControllerFiles>>,
}

impl BackupFiles for RemoteFiles {
    fn files(&self) -> &[BackupFile] {
        &self.files
    }

    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        if let Some(bytes) = self.contents.borrow().get(path) {
            return Ok(bytes.clone());
        }
        let file = ControllerPath::parse(path).map_err(|fault| fault.to_string())?;
        let bytes = self.controller.borrow_mut().read(&file, TOTAL_LIMIT).map_err(|error| error.to_string())?;
        self.contents.borrow_mut().insert(path.to_owned(), bytes.clone());
        Ok(bytes)
    }
}
