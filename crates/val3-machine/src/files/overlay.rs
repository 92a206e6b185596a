//! Files that a program has changed, in memory above the disk.
//!
//! An overlay stores each changed file and folder by path. All other files are unchanged on the disk. A copy is a
//! snapshot and shares the contents.

mod content;
mod write;

use std::collections::BTreeMap;
use std::io;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};

use super::volume::DiskState;

pub(super) use content::{ContentReader, FileContent};

/// Changed files and folders.
#[derive(Debug, Clone)]
pub struct Overlay {
    entries: Arc<BTreeMap<OverlayPath, OverlayNode>>,
    contents: Arc<BTreeMap<FileId, FileContent>>,
    next: FileId,
    /// Size of all contents, in bytes.
    bytes: u64,
    /// Maximum size of all contents, in bytes.
    limit: u64,
    /// Bytes that were written since the last copy.
    fresh: u64,
    /// Whether a write was rejected since the last `take_overflow`, because it would exceed the limit.
    has_overflowed: bool,
}

/// Location of a file or folder: volume number, and path in the volume.
pub(super) type OverlayPath = (usize, Utf8PathBuf);

/// File number, which identifies a content independent of the file name.
pub(super) type FileId = u32;

/// A file or folder that was changed.
#[derive(Debug, Clone)]
struct OverlayNode {
    /// Entry on the disk before the first change.
    disk: DiskState,
    now: OverlayItem,
}

/// A file or folder for the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum OverlayItem {
    /// Deleted.
    Missing,
    Folder,
    File(FileId),
}

impl Overlay {
    /// Creates an overlay without changes. All contents together have at most this number of bytes.
    pub(super) fn new(limit: u64) -> Self {
        Self {
            entries: Arc::default(),
            contents: Arc::default(),
            next: 0,
            bytes: 0,
            limit,
            fresh: 0,
            has_overflowed: false,
        }
    }

    /// Number of bytes written since the last copy before this one.
    pub(crate) fn fresh(&self) -> u64 {
        self.fresh
    }

    /// Returns a copy that shares all contents.
    pub(super) fn share(&mut self) -> Self {
        let copy = self.clone();
        self.fresh = 0;
        copy
    }

    /// Whether a write was rejected since the last call, because it would exceed the limit.
    pub(super) fn take_overflow(&mut self) -> bool {
        std::mem::take(&mut self.has_overflowed)
    }

    /// Returns the entry at a path; `None` if it is unchanged on the disk.
    pub(super) fn node(&self, volume: usize, path: &Utf8Path) -> Option<OverlayItem> {
        let mut place = (volume, path.to_owned());
        if let Some(entry) = self.entries.get(&place) {
            return Some(entry.now);
        }
        while place.1.pop() {
            if let Some(entry) = self.entries.get(&place) {
                // A new folder, a deleted folder and a file contain no other entries.
                let is_on_disk = entry.now == OverlayItem::Folder && entry.disk == DiskState::Folder;
                return (!is_on_disk).then_some(OverlayItem::Missing);
            }
        }
        None
    }

    /// Whether a parent of the path is a file.
    pub(super) fn is_in_file(&self, volume: usize, path: &Utf8Path) -> bool {
        let mut around = path.ancestors().skip(1).filter_map(|around| self.entries.get(&(volume, around.to_owned())));
        around.next().is_some_and(|entry| matches!(entry.now, OverlayItem::File(_)))
    }

    /// Names in a folder that differ from the disk, each with whether it exists.
    pub(super) fn names<'o>(
        &'o self,
        volume: usize,
        folder: &'o Utf8Path,
    ) -> impl Iterator<Item = (&'o str, bool)> + use<'o> {
        let below = self.entries.range((volume, folder.to_owned())..);
        let below = below.take_while(move |((number, path), _)| *number == volume && path.starts_with(folder));
        let inside = below.filter(move |((_, path), _)| path.parent() == Some(folder));
        inside.filter_map(|((_, path), entry)| Some((path.file_name()?, entry.now != OverlayItem::Missing)))
    }

    /// Sets the entry at a path. `disk` returns the entry on the disk.
    pub(super) fn set(&mut self, place: OverlayPath, node: OverlayItem, disk: impl FnOnce() -> DiskState) {
        let entry = Arc::make_mut(&mut self.entries).entry(place);
        let entry = entry.or_insert_with(|| OverlayNode { disk: disk(), now: OverlayItem::Missing });
        entry.now = node;
    }

    /// Adds a content as a file.
    pub(super) fn add(&mut self, content: FileContent) -> io::Result<FileId> {
        self.take_room(content.bytes())?;
        let id = self.next;
        self.next += 1;
        Arc::make_mut(&mut self.contents).insert(id, content);
        Ok(id)
    }

    /// The content of a file.
    pub(super) fn content(&self, file: FileId) -> FileContent {
        self.contents.get(&file).cloned().unwrap_or_default()
    }

    /// Appends to a file. Bytes for a deleted file are lost, as on a disk.
    pub(super) fn append(&mut self, file: FileId, bytes: &[u8]) -> io::Result<()> {
        if self.contents.contains_key(&file) {
            self.take_room(bytes.len() as u64)?;
            if let Some(content) = Arc::make_mut(&mut self.contents).get_mut(&file) {
                content.append(bytes);
            }
        }
        Ok(())
    }

    /// Empties a file.
    pub(super) fn truncate(&mut self, file: FileId) {
        if let Some(content) = Arc::make_mut(&mut self.contents).get_mut(&file) {
            self.bytes -= std::mem::take(content).bytes();
        }
    }

    /// Drops the content of a file that was deleted.
    pub(super) fn forget(&mut self, file: FileId) {
        if let Some(content) = Arc::make_mut(&mut self.contents).remove(&file) {
            self.bytes -= content.bytes();
        }
    }

    fn take_room(&mut self, bytes: u64) -> io::Result<()> {
        if self.bytes + bytes > self.limit {
            self.has_overflowed = true;
            return Err(io::ErrorKind::QuotaExceeded.into());
        }
        self.bytes += bytes;
        self.fresh += bytes;
        Ok(())
    }
}

#[cfg(test)]
mod tests;
