//! Changes of files and folders, on the disk or in the overlay above it.

use std::io;

use camino::Utf8Path;

use super::{DiskState, EntryKind, Volume, relative};
use crate::files::FileFault;
use crate::files::overlay::{FileContent, FileId, OverlayItem};

impl Volume {
    /// Whether changes go to the overlay.
    pub(super) fn is_covered(&self) -> bool {
        self.overlay.borrow().is_some()
    }

    /// Deletes a file.
    pub(in crate::files) fn remove_file(&self, path: &Utf8Path) -> io::Result<()> {
        if !self.is_covered() {
            return self.dir.remove_file(relative(path));
        }
        match self.existing(path)? {
            EntryKind::Folder => Err(io::ErrorKind::IsADirectory.into()),
            _ => {
                self.replace(path, OverlayItem::Missing);
                Ok(())
            }
        }
    }

    /// Deletes an empty folder.
    pub(in crate::files) fn remove_dir(&self, path: &Utf8Path) -> io::Result<()> {
        if !self.is_covered() {
            return self.dir.remove_dir(relative(path));
        }
        if !self.folder_names(path)?.is_empty() {
            return Err(io::ErrorKind::DirectoryNotEmpty.into());
        }
        self.replace(path, OverlayItem::Missing);
        Ok(())
    }

    /// Deletes a folder with its content. Links in it are deleted, not followed.
    ///
    /// # Errors
    /// An entry cannot be read. The entries before it are deleted, as on the disk.
    pub(in crate::files) fn remove_dir_all(&self, path: &Utf8Path) -> io::Result<()> {
        if !self.is_covered() {
            return self.dir.remove_dir_all(relative(path));
        }
        for name in self.folder_names(path)? {
            let inner = path.join(name);
            if self.is_folder_itself(&inner)? {
                self.remove_dir_all(&inner)?;
            } else {
                self.replace(&inner, OverlayItem::Missing);
            }
        }
        self.replace(path, OverlayItem::Missing);
        Ok(())
    }

    /// Creates a folder.
    pub(in crate::files) fn create_dir(&self, path: &Utf8Path) -> io::Result<()> {
        if !self.is_covered() {
            return self.dir.create_dir(relative(path));
        }
        self.check_parent(path)?;
        match self.kind_of(path)? {
            EntryKind::Missing => {
                self.replace(path, OverlayItem::Folder);
                Ok(())
            }
            EntryKind::File | EntryKind::Folder => Err(io::ErrorKind::AlreadyExists.into()),
        }
    }

    /// Creates a folder and its parents, unless they exist.
    pub(in crate::files) fn create_dir_all(&self, path: &Utf8Path) -> io::Result<()> {
        if !self.is_covered() {
            return self.dir.create_dir_all(relative(path));
        }
        match self.kind_of(path)? {
            EntryKind::Folder => Ok(()),
            EntryKind::File => Err(io::ErrorKind::NotADirectory.into()),
            EntryKind::Missing => {
                path.parent().map_or(Ok(()), |around| self.create_dir_all(around))?;
                self.create_dir(path)
            }
        }
    }

    /// Moves a folder, or a file, which replaces an existing file.
    ///
    /// # Errors
    /// [`CrossesDevices`](io::ErrorKind::CrossesDevices) if the disk cannot move to the other volume.
    pub(in crate::files) fn rename(&self, from: &Utf8Path, to: &Self, target: &Utf8Path) -> io::Result<()> {
        if !self.is_covered() {
            return self.dir.rename(relative(from), &to.dir, relative(target));
        }
        to.check_parent(target)?;
        if self.number == to.number && from == target {
            return Ok(());
        }
        match self.existing(from)? {
            EntryKind::Folder => self.rename_folder(from, to, target),
            _ if to.kind_of(target)? == EntryKind::Folder => Err(io::ErrorKind::IsADirectory.into()),
            _ => {
                let file = self.capture(from)?;
                to.replace(target, OverlayItem::File(file));
                self.note(from, OverlayItem::Missing);
                Ok(())
            }
        }
    }

    fn rename_folder(&self, from: &Utf8Path, to: &Self, target: &Utf8Path) -> io::Result<()> {
        to.create_dir(target)?;
        for name in self.folder_names(from)? {
            self.rename(&from.join(&name), to, &target.join(&name))?;
        }
        self.replace(from, OverlayItem::Missing);
        Ok(())
    }

    /// Copies a file, which replaces an existing file.
    pub(in crate::files) fn copy(&self, from: &Utf8Path, to: &Self, target: &Utf8Path) -> io::Result<()> {
        if !self.is_covered() {
            return self.dir.copy(relative(from), &to.dir, relative(target)).map(drop);
        }
        to.put(target, self.content(from)?).map(drop)
    }

    /// Writes the content of a folder to the physical medium, so that it survives a power cut.
    #[cfg(unix)]
    pub(in crate::files) fn sync(&self, folder: &Utf8Path) -> io::Result<()> {
        if self.is_covered() { Ok(()) } else { self.dir.open(relative(folder))?.sync_all() }
    }

    /// Does nothing: other systems cannot sync a folder, and their file systems write its entries themselves.
    #[cfg(not(unix))]
    pub(in crate::files) fn sync(&self, _folder: &Utf8Path) -> io::Result<()> {
        Ok(())
    }

    /// Creates a file with this content, in place of any existing file.
    pub(super) fn put(&self, path: &Utf8Path, content: FileContent) -> io::Result<FileId> {
        self.check_parent(path)?;
        if self.kind_of(path)? == EntryKind::Folder {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        self.check_writable(path)?;
        let file = self.add(content)?;
        self.replace(path, OverlayItem::File(file));
        Ok(file)
    }

    /// Adds a file to the overlay.
    pub(super) fn capture(&self, path: &Utf8Path) -> io::Result<FileId> {
        if let Some(OverlayItem::File(file)) = self.node(path) {
            return Ok(file);
        }
        let file = self.add(self.content(path)?)?;
        self.replace(path, OverlayItem::File(file));
        Ok(file)
    }

    fn add(&self, content: FileContent) -> io::Result<FileId> {
        self.in_overlay(|overlay| overlay.add(content)).unwrap_or(Err(io::ErrorKind::NotFound.into()))
    }

    /// Replaces the entry at a path. The content of a previous file is dropped.
    fn replace(&self, path: &Utf8Path, node: OverlayItem) {
        if let Some(OverlayItem::File(old)) = self.node(path) {
            self.in_overlay(|overlay| overlay.forget(old));
        }
        self.note(path, node);
    }

    /// Sets the entry at a path.
    fn note(&self, path: &Utf8Path, node: OverlayItem) {
        let disk = || self.inputs.ask(|| DiskState::of(&self.dir, path));
        self.in_overlay(|overlay| overlay.set((self.number, path.to_owned()), node, disk));
    }

    fn kind_of(&self, path: &Utf8Path) -> io::Result<EntryKind> {
        self.kind(path).map_err(|fault| match fault {
            FileFault::BadPath => io::ErrorKind::NotADirectory.into(),
            _ => io::ErrorKind::Other.into(),
        })
    }

    fn existing(&self, path: &Utf8Path) -> io::Result<EntryKind> {
        match self.kind_of(path)? {
            EntryKind::Missing => Err(io::ErrorKind::NotFound.into()),
            kind => Ok(kind),
        }
    }

    fn folder_names(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        match self.existing(path)? {
            EntryKind::Folder => self.names(path),
            _ => Err(io::ErrorKind::NotADirectory.into()),
        }
    }

    /// Checks that the parent folder of a path exists.
    fn check_parent(&self, path: &Utf8Path) -> io::Result<()> {
        match self.existing(path.parent().unwrap_or(Utf8Path::new("")))? {
            EntryKind::Folder => Ok(()),
            _ => Err(io::ErrorKind::NotADirectory.into()),
        }
    }

    /// Checks that the disk permits writes to an existing file.
    pub(super) fn check_writable(&self, path: &Utf8Path) -> io::Result<()> {
        if self.node(path).is_some() || self.kind_of(path)? == EntryKind::Missing {
            return Ok(());
        }
        let mut options = cap_std::fs::OpenOptions::new();
        options.write(true);
        self.ask(|dir| dir.open_with(relative(path), &options).map(drop))
    }
}
