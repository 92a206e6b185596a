//! The files that a program has changed, in memory above the disk.
//!
//! An overlay knows each file and folder that was changed, by its place. Everything else is as on the disk. A copy is a
//! snapshot: it shares the contents.

mod content;
mod write;

use std::collections::BTreeMap;
use std::io;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};

use super::volume::DiskState;

pub(super) use content::{Content, Reader};

/// The changed files and folders.
#[derive(Debug, Clone)]
pub struct Overlay {
    entries: Arc<BTreeMap<Place, Entry>>,
    contents: Arc<BTreeMap<FileId, Content>>,
    next: FileId,
    /// The bytes of all contents.
    bytes: u64,
    /// The most bytes of all contents.
    limit: u64,
    /// Bytes that were written since the last copy.
    fresh: u64,
    /// Something was not written since the last question for it, because it would go beyond the limit.
    has_overflowed: bool,
}

/// Where a file or folder is: the number of its volume, and its path there.
pub(super) type Place = (usize, Utf8PathBuf);

/// A file with its content, whatever its name.
pub(super) type FileId = u32;

/// A file or folder that was changed.
#[derive(Debug, Clone)]
struct Entry {
    /// The disk when it was changed first.
    disk: DiskState,
    now: Node,
}

/// A file or folder for the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Node {
    /// It was deleted.
    Missing,
    Folder,
    File(FileId),
}

impl Overlay {
    /// Without changes. All contents together have at most this many bytes.
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

    /// The bytes that were written since the last copy before this one.
    pub(crate) fn fresh(&self) -> u64 {
        self.fresh
    }

    /// A copy that shares everything with this one.
    pub(super) fn share(&mut self) -> Self {
        let copy = self.clone();
        self.fresh = 0;
        copy
    }

    /// Whether something was not written since the last call, because it would go beyond the limit.
    pub(super) fn take_overflow(&mut self) -> bool {
        std::mem::take(&mut self.has_overflowed)
    }

    /// The entry at a place; `None` if it is as on the disk.
    pub(super) fn node(&self, volume: usize, path: &Utf8Path) -> Option<Node> {
        let mut place = (volume, path.to_owned());
        if let Some(entry) = self.entries.get(&place) {
            return Some(entry.now);
        }
        while place.1.pop() {
            if let Some(entry) = self.entries.get(&place) {
                // Nothing else is in a new folder, in one that was deleted, or in a file.
                let is_on_disk = entry.now == Node::Folder && entry.disk == DiskState::Folder;
                return (!is_on_disk).then_some(Node::Missing);
            }
        }
        None
    }

    /// A path leads through a file.
    pub(super) fn is_in_file(&self, volume: usize, path: &Utf8Path) -> bool {
        let mut around = path.ancestors().skip(1).filter_map(|around| self.entries.get(&(volume, around.to_owned())));
        around.next().is_some_and(|entry| matches!(entry.now, Node::File(_)))
    }

    /// The names in a folder that differ from those on the disk, each with whether it is there.
    pub(super) fn names<'o>(
        &'o self,
        volume: usize,
        folder: &'o Utf8Path,
    ) -> impl Iterator<Item = (&'o str, bool)> + use<'o> {
        let below = self.entries.range((volume, folder.to_owned())..);
        let below = below.take_while(move |((number, path), _)| *number == volume && path.starts_with(folder));
        let inside = below.filter(move |((_, path), _)| path.parent() == Some(folder));
        inside.filter_map(|((_, path), entry)| Some((path.file_name()?, entry.now != Node::Missing)))
    }

    /// Changes what is at a place. `disk` gives what the disk has there.
    pub(super) fn set(&mut self, place: Place, node: Node, disk: impl FnOnce() -> DiskState) {
        let entry = Arc::make_mut(&mut self.entries).entry(place);
        let entry = entry.or_insert_with(|| Entry { disk: disk(), now: Node::Missing });
        entry.now = node;
    }

    /// Makes a content known as a file.
    pub(super) fn add(&mut self, content: Content) -> io::Result<FileId> {
        self.take_room(content.bytes())?;
        let id = self.next;
        self.next += 1;
        Arc::make_mut(&mut self.contents).insert(id, content);
        Ok(id)
    }

    /// The content of a file.
    pub(super) fn content(&self, file: FileId) -> Content {
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
