//! Files below folders, on the controller and here.

use std::collections::{BTreeMap, BTreeSet};

use crate::access::{AccessError, AccessFault, ControllerFiles};
use crate::digest::{FileDigest, FileDigests};
use crate::error::ControllerError;
use crate::observer::{TransferObserver, TransferStep, check_interrupt};
use crate::path::ControllerPath;
use crate::rules::is_ignored;

/// Limit of all transferred files, in bytes.
pub const TOTAL_LIMIT: u64 = 500 << 20;

/// Limit of nested folders.
const DEPTH_LIMIT: usize = 32;

/// Maximum number of files and folders.
const COUNT_LIMIT: usize = 100_000;

/// Returns the files below folders, without ignored ones. Folders that do not exist have no files.
///
/// # Errors
/// If a folder cannot be listed, a name is not allowed, two names differ only in letter case, or a limit is exceeded.
pub fn files_below(
    files: &mut dyn ControllerFiles,
    folders: &[ControllerPath],
    observer: &mut dyn TransferObserver,
) -> Result<BTreeSet<ControllerPath>, ControllerError> {
    search(files, folders, observer, &mut |_, error| Err(error.into()))
}

/// Receiver of files and folders that cannot be read. An error ends the operation.
type OnFault<'a> = dyn FnMut(&ControllerPath, AccessError) -> Result<(), ControllerError> + 'a;

fn search(
    files: &mut dyn ControllerFiles,
    folders: &[ControllerPath],
    observer: &mut dyn TransferObserver,
    on_fault: &mut OnFault<'_>,
) -> Result<BTreeSet<ControllerPath>, ControllerError> {
    observer.step(TransferStep::List, 0);
    let mut found = BTreeSet::new();
    let mut presence = Presence::default();
    let mut open = Vec::new();
    for folder in folders {
        if presence.has(files, folder)? {
            open.push(folder.clone());
        }
    }
    let mut count = 0;
    while let Some(folder) = open.pop() {
        check_interrupt(observer)?;
        if folder.depth() > DEPTH_LIMIT {
            return Err(ControllerError::TooDeep(folder));
        }
        let entries = match files.list(&folder) {
            Ok(entries) => entries,
            Err(error) => {
                on_fault(&folder, error)?;
                continue;
            }
        };
        check_case(entries.iter().map(|entry| &entry.path))?;
        count += entries.len();
        if count > COUNT_LIMIT {
            return Err(ControllerError::TooMany(COUNT_LIMIT));
        }
        for entry in entries.into_iter().filter(|entry| !is_ignored(&entry.path)) {
            if entry.is_folder {
                open.push(entry.path);
            } else {
                found.insert(entry.path);
            }
        }
    }
    Ok(found)
}

/// Checks that no two paths, or folders above them, differ only in letter case.
pub(crate) fn check_case<'p>(paths: impl Iterator<Item = &'p ControllerPath>) -> Result<(), ControllerError> {
    let mut seen: BTreeMap<String, ControllerPath> = BTreeMap::new();
    for path in paths {
        for path in std::iter::successors(Some(path.clone()), ControllerPath::parent) {
            match seen.get(&path.as_str().to_lowercase()) {
                Some(other) if *other != path => return Err(ControllerError::SameName(other.clone(), path)),
                // The folders above it were checked, too.
                Some(_) => break,
                None => _ = seen.insert(path.as_str().to_lowercase(), path),
            }
        }
    }
    Ok(())
}

/// Receiver of downloaded files.
pub(crate) type StoreFile<'a> = dyn FnMut(&ControllerPath, &[u8]) -> Result<(), ControllerError> + 'a;

/// Downloads files, and passes each to `store`.
///
/// # Errors
/// If a file cannot be read or stored, or all files exceed the limit.
pub(crate) fn download(
    files: &mut dyn ControllerFiles,
    paths: &BTreeSet<ControllerPath>,
    observer: &mut dyn TransferObserver,
    store: &mut StoreFile<'_>,
) -> Result<FileDigests, ControllerError> {
    observer.step(TransferStep::Download, paths.len());
    let mut left = TOTAL_LIMIT;
    let mut digests = FileDigests::new();
    for path in paths {
        check_interrupt(observer)?;
        let bytes = read_within(files, path, left)?;
        store(path, &bytes)?;
        left = left.saturating_sub(bytes.len() as u64);
        observer.file(path, bytes.len() as u64);
        digests.insert(path.clone(), FileDigest::of(&bytes));
    }
    Ok(digests)
}

/// Returns the contents of all files below folders, without ignored ones.
///
/// # Errors
/// If a folder or file cannot be read, or a limit is exceeded.
pub fn read_files(
    files: &mut dyn ControllerFiles,
    folders: &[ControllerPath],
    observer: &mut dyn TransferObserver,
) -> Result<BTreeMap<ControllerPath, Vec<u8>>, ControllerError> {
    let paths = files_below(files, folders, observer)?;
    let mut contents = BTreeMap::new();
    download(files, &paths, observer, &mut |path, bytes| {
        contents.insert(path.clone(), bytes.to_vec());
        Ok(())
    })?;
    Ok(contents)
}

/// Files of a controller that a command only describes.
#[derive(Debug, Default)]
pub struct ReadableFiles {
    /// Contents of the files that were read.
    pub contents: BTreeMap<ControllerPath, Vec<u8>>,
    /// Files that the controller does not let the user read, with the reason.
    pub unread: BTreeMap<ControllerPath, AccessFault>,
    /// Folders that the controller does not let the user list, with the reason.
    pub unlisted: BTreeMap<ControllerPath, AccessFault>,
}

/// Like [`read_files`], for commands that need not read everything: rejected files and folders are returned, too.
///
/// # Errors
/// If the connection is lost, a file or name cannot be understood, or a limit is exceeded.
pub fn read_readable_files(
    files: &mut dyn ControllerFiles,
    folders: &[ControllerPath],
    observer: &mut dyn TransferObserver,
) -> Result<ReadableFiles, ControllerError> {
    let mut unlisted = BTreeMap::new();
    let paths = search(files, folders, observer, &mut |path, error| only_denied(path, error, &mut unlisted))?;
    observer.step(TransferStep::Download, paths.len());
    let mut read = ReadableFiles { unlisted, ..ReadableFiles::default() };
    let mut left = TOTAL_LIMIT;
    for path in paths {
        check_interrupt(observer)?;
        match read_within(files, &path, left) {
            Ok(bytes) => {
                left = left.saturating_sub(bytes.len() as u64);
                observer.file(&path, bytes.len() as u64);
                read.contents.insert(path, bytes);
            }
            Err(ControllerError::Access(error)) => only_denied(&path, error, &mut read.unread)?,
            Err(error) => return Err(error),
        }
    }
    Ok(read)
}

/// Adds the reason why an entry cannot be read. Other errors end the operation.
fn only_denied(
    path: &ControllerPath,
    error: AccessError,
    denied: &mut BTreeMap<ControllerPath, AccessFault>,
) -> Result<(), ControllerError> {
    if error.is_of_one_entry() {
        denied.insert(path.clone(), error.reason);
        Ok(())
    } else {
        Err(error.into())
    }
}

/// Reads a file with at most the number of bytes that is left for all files.
fn read_within(files: &mut dyn ControllerFiles, path: &ControllerPath, left: u64) -> Result<Vec<u8>, ControllerError> {
    files.read(path, left).map_err(|error| match error.reason {
        AccessFault::TooLarge(_) => ControllerError::TooMuch(TOTAL_LIMIT),
        _ => error.into(),
    })
}

/// Returns a file's content.
///
/// # Errors
/// If the file does not exist or cannot be read.
pub fn read_file(files: &mut dyn ControllerFiles, path: &ControllerPath) -> Result<Vec<u8>, ControllerError> {
    if Presence::default().has(files, path)? {
        Ok(files.read(path, TOTAL_LIMIT)?)
    } else {
        Err(ControllerError::Missing(path.clone()))
    }
}

/// Checks that the controller has the folder of the applications: another place, such as the folder `usr` itself, has no
/// applications, which must not look like a controller whose applications were all removed.
///
/// # Errors
/// If the folder does not exist, or a folder above it cannot be listed.
pub fn check_applications(files: &mut dyn ControllerFiles) -> Result<(), ControllerError> {
    if Presence::default().has(files, &ControllerPath::applications())? {
        Ok(())
    } else {
        Err(ControllerError::NoApplications { place: files.place().to_owned() })
    }
}

/// Names of the folders below the applications.
pub(crate) fn application_names(files: &mut dyn ControllerFiles) -> Result<Vec<String>, ControllerError> {
    let entries = files.list(&ControllerPath::applications())?;
    let names = entries.iter().filter(|entry| entry.is_folder && !is_ignored(&entry.path));
    Ok(names.map(|entry| entry.path.name().to_owned()).collect())
}

/// Existing entries, listed once for each folder.
#[derive(Default)]
pub(crate) struct Presence {
    folders: BTreeMap<ControllerPath, BTreeSet<ControllerPath>>,
}

impl Presence {
    /// Whether a file or folder exists, according to the listings of the folders above it.
    pub(crate) fn has(
        &mut self,
        files: &mut dyn ControllerFiles,
        path: &ControllerPath,
    ) -> Result<bool, ControllerError> {
        let Some(folder) = path.parent() else { return Ok(true) };
        if !self.folders.contains_key(&folder) {
            let is_present = self.has(files, &folder)?;
            let entries = if is_present { files.list(&folder)? } else { Vec::new() };
            self.folders.insert(folder.clone(), entries.into_iter().map(|entry| entry.path).collect());
        }
        Ok(self.folders.get(&folder).is_some_and(|entries| entries.contains(path)))
    }
}
