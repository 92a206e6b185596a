//! Files of a controller at an address. Nothing is written, neither here nor on the controller.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use camino::{Utf8Path, Utf8PathBuf};
use val3_backup::{BackupFile, BackupFiles};
use val3_controller::{
    AccessFault, ControllerFiles, ControllerPath, ReadableFiles, TOTAL_LIMIT, files_below, read_readable_files,
};

use super::OpenedBackup;
use crate::args::ConnectionArgs;
use crate::controller::{ControllerTarget, ProgressObserver, parse_address, surrounding_state};
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
/// The address is wrong, the controller cannot be reached, or one of the listed folders cannot be read.
pub(crate) fn open_address(
    address: &Utf8Path,
    connection: &ConnectionArgs,
    folders: &RemoteFolders,
) -> Result<OpenedBackup, UserError> {
    let state = surrounding_state()?;
    let mut target = ControllerTarget::new(parse_address(address.as_str())?, connection, state.as_ref())?;
    let mut controller = target.connect()?;
    let mut observer = ProgressObserver::default();
    let readable = read_readable_files(&mut *controller, &paths(folders.downloaded)?, &mut observer)?;
    let listed = files_below(&mut *controller, &paths(folders.listed)?, &mut observer)?;
    observer.end();
    let root = Utf8PathBuf::from(target.address.to_string());
    let ReadableFiles { contents, unread, unlisted } = readable;
    let named = |(path, reason): (&ControllerPath, &AccessFault)| (root.join(path.as_str()), reason.to_string());
    let (denied, unsearched) = (unread.iter().map(named).collect(), unlisted.iter().map(named).collect());
    let read = contents.into_iter().map(|(path, bytes)| (path.into(), Ok(bytes)));
    let unread = unread.into_iter().map(|(path, reason)| (path.into(), Err(reason.to_string())));
    let contents: BTreeMap<String, FileContent> = read.chain(unread).collect();
    let names: BTreeSet<String> = listed.into_iter().map(String::from).chain(contents.keys().cloned()).collect();
    // The clock of a controller is not reliable, so that files have no dates.
    let file = |path| BackupFile { size: size(contents.get(&path)), path, modified: None };
    let files = names.into_iter().map(file).collect();
    let files = RemoteFiles { files, contents: RefCell::new(contents), controller: RefCell::new(controller) };
    Ok(OpenedBackup { files: Box::new(files), root, unread: unsearched, denied })
}

/// Content of a file, or the reason why it cannot be read.
type FileContent = Result<Vec<u8>, String>;

/// Size of a downloaded file, in bytes; 0 if it is unknown.
fn size(content: Option<&FileContent>) -> u64 {
    content.and_then(|content| content.as_ref().ok()).map_or(0, |bytes| bytes.len().try_into().unwrap_or(u64::MAX))
}

fn paths(folders: &[&str]) -> Result<Vec<ControllerPath>, UserError> {
    let path = |text: &&str| ControllerPath::parse(text).map_err(|fault| UserError::new(fault.to_string()));
    folders.iter().map(path).collect()
}

/// Files on a controller.
struct RemoteFiles {
    files: Vec<BackupFile>,
    /// Downloaded files by path.
    contents: RefCell<BTreeMap<String, FileContent>>,
    controller: RefCell<Box<dyn ControllerFiles>>,
}

impl BackupFiles for RemoteFiles {
    fn files(&self) -> &[BackupFile] {
        &self.files
    }

    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        if let Some(content) = self.contents.borrow().get(path) {
            return content.clone();
        }
        let file = ControllerPath::parse(path).map_err(|fault| fault.to_string())?;
        let content = self.controller.borrow_mut().read(&file, TOTAL_LIMIT).map_err(|error| error.to_string());
        self.contents.borrow_mut().insert(path.to_owned(), content.clone());
        content
    }
}
