//! A mounted folder on the disk, with or without an overlay above it.
//!
//! Results from the disk below an overlay pass through the recorder of external input. The overlay itself is state: a
//! replay repeats its changes.

mod changes;
mod files;

use std::cell::RefCell;
use std::io;
use std::rc::Rc;

use camino::Utf8Path;
use cap_std::fs_utf8::Dir;
use cap_std::time::SystemTime;

use super::overlay::{FileContent, Overlay, OverlayItem};
use super::{EntryKind, FileFault};
use crate::inputs::{Answer, Inputs};

pub(super) use files::{InFile, OutFile};

/// Overlay that the volumes of a controller share; `None` while they change the disk.
pub(super) type SharedOverlay = Rc<RefCell<Option<Overlay>>>;

/// Maximum size of a file that is read completely, in bytes.
pub(super) const LARGEST: u64 = 256 << 20;

/// A folder that no path can leave. The empty path is the folder itself.
#[derive(Debug)]
pub(super) struct Volume {
    pub(super) dir: Dir,
    pub(super) number: usize,
    pub(super) overlay: SharedOverlay,
    pub(super) inputs: Inputs,
}

/// Entry on the disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum DiskState {
    Missing,
    Folder,
    /// File with size and modification time.
    File(u64, Option<SystemTime>),
}

impl Answer for DiskState {}

impl Answer for EntryKind {}

impl Answer for FileContent {
    fn held_bytes(&self) -> usize {
        usize::try_from(self.bytes()).unwrap_or(usize::MAX)
    }
}

impl Volume {
    /// The kind of entry at a path.
    pub(super) fn kind(&self, path: &Utf8Path) -> Result<EntryKind, FileFault> {
        match self.node(path) {
            Some(OverlayItem::Missing) if self.is_in_file(path) => Err(FileFault::BadPath),
            Some(OverlayItem::Missing) => Ok(EntryKind::Missing),
            Some(OverlayItem::Folder) => Ok(EntryKind::Folder),
            Some(OverlayItem::File(_)) => Ok(EntryKind::File),
            None => self.inputs.ask_usual(&Ok(EntryKind::Folder), || self.kind_on_disk(path)),
        }
    }

    /// Whether the entry at a path is a link itself. Changes in memory are no links.
    pub(super) fn is_link(&self, path: &Utf8Path) -> bool {
        self.node(path).is_none() && self.inputs.ask_usual(&false, || self.is_link_on_disk(path))
    }

    fn is_link_on_disk(&self, path: &Utf8Path) -> bool {
        self.dir.symlink_metadata(relative(path)).is_ok_and(|found| found.is_symlink())
    }

    /// Whether the entry at a path is a folder, and no link to a folder.
    fn is_folder_itself(&self, path: &Utf8Path) -> io::Result<bool> {
        match self.node(path) {
            Some(item) => Ok(item == OverlayItem::Folder),
            None => self.ask(|dir| Ok(dir.symlink_metadata(relative(path))?.is_dir())),
        }
    }

    fn kind_on_disk(&self, path: &Utf8Path) -> Result<EntryKind, FileFault> {
        match self.dir.metadata(relative(path)) {
            Ok(found) if found.is_dir() => Ok(EntryKind::Folder),
            Ok(found) if found.is_file() => Ok(EntryKind::File),
            // A pipe or device would block the run.
            Ok(_) => Err(FileFault::BadPath),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(EntryKind::Missing),
            Err(error) if error.kind() == io::ErrorKind::PermissionDenied => Err(FileFault::BadPath),
            Err(error) => Err(error.into()),
        }
    }

    /// Names in a folder, sorted without regard to letter case. A name that is no text is omitted.
    pub(super) fn names(&self, folder: &Utf8Path) -> io::Result<Vec<String>> {
        let mut names = match self.node(folder) {
            Some(_) if self.state_on_disk(folder) != DiskState::Folder => Vec::new(),
            _ => self.ask(|dir| {
                let mut names = Vec::new();
                for entry in dir.read_dir(relative(folder))? {
                    names.extend(entry?.file_name());
                }
                Ok(names)
            })?,
        };
        if let Some(overlay) = &*self.overlay.borrow() {
            for (name, is_there) in overlay.names(self.number, folder) {
                names.retain(|known| known != name);
                names.extend(is_there.then(|| name.to_owned()));
            }
        }
        names.sort_by_cached_key(|name| (name.to_lowercase(), name.clone()));
        Ok(names)
    }

    /// The bytes of a file.
    pub(super) fn read(&self, path: &Utf8Path) -> io::Result<Vec<u8>> {
        Ok(self.content(path)?.to_vec())
    }

    /// The content of a file.
    fn content(&self, path: &Utf8Path) -> io::Result<FileContent> {
        match self.node(path) {
            Some(OverlayItem::File(file)) => Ok(self.in_overlay(|overlay| overlay.content(file)).unwrap_or_default()),
            Some(OverlayItem::Missing) => Err(io::ErrorKind::NotFound.into()),
            Some(OverlayItem::Folder) => Err(io::ErrorKind::IsADirectory.into()),
            None => self.ask(|dir| read(dir, path)),
        }
    }

    /// Entry of the overlay at a path; `None` if it is unchanged on the disk.
    fn node(&self, path: &Utf8Path) -> Option<OverlayItem> {
        self.overlay.borrow().as_ref()?.node(self.number, path)
    }

    fn is_in_file(&self, path: &Utf8Path) -> bool {
        self.overlay.borrow().as_ref().is_some_and(|overlay| overlay.is_in_file(self.number, path))
    }

    fn state_on_disk(&self, path: &Utf8Path) -> DiskState {
        self.inputs.ask(|| DiskState::of(&self.dir, path))
    }

    /// Calls the disk. Below an overlay the result is recorded.
    fn ask<T: Answer>(&self, question: impl FnOnce(&Dir) -> io::Result<T>) -> io::Result<T> {
        self.inputs.ask(|| question(&self.dir).map_err(|error| error.kind())).map_err(io::Error::from)
    }

    fn in_overlay<T>(&self, act: impl FnOnce(&mut Overlay) -> T) -> Option<T> {
        self.overlay.borrow_mut().as_mut().map(act)
    }
}

impl DiskState {
    pub(super) fn of(dir: &Dir, path: &Utf8Path) -> Self {
        match dir.metadata(relative(path)) {
            Ok(found) if found.is_dir() => Self::Folder,
            Ok(found) => Self::File(found.len(), found.modified().ok()),
            Err(_) => Self::Missing,
        }
    }
}

/// Reads a file on the disk, unless it exceeds the size that a controller can store.
fn read(dir: &Dir, path: &Utf8Path) -> io::Result<FileContent> {
    match dir.metadata(relative(path))?.len() > LARGEST {
        true => Err(io::ErrorKind::Other.into()),
        false => Ok(FileContent::new(dir.read(relative(path))?)),
    }
}

/// Returns the path for the operating system: `.` for the folder itself.
pub(super) fn relative(path: &Utf8Path) -> &Utf8Path {
    if path.as_str().is_empty() { Utf8Path::new(".") } else { path }
}
