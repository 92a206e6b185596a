//! Media and their folders. A [`MountedPath`] is always inside of its folder: upward steps, links and absolute paths
//! end at the folder, which the operating system holds open (`cap-std`).

use std::io;

use camino::{Utf8Component, Utf8Path, Utf8PathBuf};
use cap_std::ambient_authority;
use cap_std::fs_utf8::Dir;

use super::overlay::Overlay;
use super::path::DISK;
use super::reserved::is_reserved;
use super::volume::{SharedOverlay, Volume};
use super::{ControllerPath, FileFault};
use crate::inputs::Inputs;

/// The mounted media: `Disk`, `USB0`, `Floppy`, and any other name from outside.
#[derive(Debug, Default)]
pub struct Roots {
    media: Vec<MountedMedium>,
    /// Changes of programs until they are written.
    overlay: SharedOverlay,
}

#[derive(Debug)]
struct MountedMedium {
    name: String,
    /// The folder that no path can leave.
    volume: Volume,
    /// Start folder of paths in the volume; one upward step removes one part.
    start: Vec<String>,
}

/// Existing or missing file or folder inside of a mounted folder.
#[derive(Debug, Clone)]
pub struct MountedPath<'r> {
    /// The folder that no path can leave.
    pub(super) volume: &'r Volume,
    /// Path in the volume, in the letter case of the medium; never absolute and without upward steps.
    pub(super) path: Utf8PathBuf,
}

/// The kind of entry at a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EntryKind {
    /// Nothing.
    Missing,
    /// A file.
    File,
    /// A folder.
    Folder,
}

impl Roots {
    /// Mounts `folder` as `name`, in place of any previous folder.
    ///
    /// # Errors
    /// If the folder cannot be opened.
    pub fn mount(&mut self, name: &str, folder: &Utf8Path) -> io::Result<()> {
        self.mount_inside(name, folder, Utf8Path::new(""))
    }

    /// Mounts the folder of the applications as `Disk`. The folder in a cell is `usr/usrapp`: its paths can go up to
    /// `usr`, which contains the templates, and no further.
    ///
    /// # Errors
    /// If the folder cannot be opened.
    pub fn mount_disk(&mut self, folder: &Utf8Path) -> io::Result<()> {
        let is = |path: &Utf8Path, name: &str| path.file_name().is_some_and(|found| found.eq_ignore_ascii_case(name));
        match (folder.parent(), folder.file_name()) {
            (Some(outer), Some(name)) if is(folder, "usrapp") && is(outer, "usr") => {
                self.mount_inside(DISK, outer, Utf8Path::new(name))
            }
            _ => self.mount(DISK, folder),
        }
    }

    /// Mounts the folder `start` inside of `outer` as `name`. Its paths can go up to `outer`, for example
    /// `Disk://../templates` in a cell.
    ///
    /// # Errors
    /// If the folder cannot be opened.
    pub fn mount_inside(&mut self, name: &str, outer: &Utf8Path, start: &Utf8Path) -> io::Result<()> {
        let dir = Dir::open_ambient_dir(outer, ambient_authority())?;
        let start = start.components().map(|part| part.as_str().to_owned()).collect();
        self.media.retain(|medium| !medium.name.eq_ignore_ascii_case(name));
        let number = self.media.last().map_or(0, |last| last.volume.number + 1);
        let volume = Volume { dir, number, overlay: SharedOverlay::clone(&self.overlay), inputs: Inputs::default() };
        self.media.push(MountedMedium { name: name.to_owned(), volume, start });
        Ok(())
    }

    /// Resolves a path. Letter case does not count: if no name has the same spelling, the first name in order that
    /// differs only in case is used.
    ///
    /// # Errors
    /// [`FileFault::BadRoot`] for a medium that is not mounted, [`FileFault::BadPath`] for a path that would leave the
    /// medium or that continues after a file.
    pub fn place(&self, path: &ControllerPath) -> Result<MountedPath<'_>, FileFault> {
        let medium = self.media.iter().find(|medium| medium.name.eq_ignore_ascii_case(path.medium()));
        let medium = medium.ok_or(FileFault::BadRoot)?;
        let steps = path.parts().iter().take_while(|part| *part == "..").count();
        let kept = medium.start.len().checked_sub(steps).ok_or(FileFault::BadPath)?;
        let start = medium.start.iter().take(kept).map(String::as_str);
        let names = start.chain(path.parts().iter().skip(steps).map(|part| part.as_str()));
        let mut place = MountedPath { volume: &medium.volume, path: Utf8PathBuf::new() };
        for name in names {
            place = place.child(name)?;
        }
        Ok(place)
    }

    /// The path with the letter case on the medium.
    ///
    /// # Errors
    /// As [`Self::place`].
    pub fn spelled(&self, path: &ControllerPath) -> Result<ControllerPath, FileFault> {
        let place = self.place(path)?;
        Ok(path.with_names(&place.path))
    }

    /// Covers the media: from now on all changes stay in memory, and each result of the media is recorded. Returns
    /// `false` if the media were covered already.
    pub(crate) fn cover(&mut self, inputs: &Inputs, limit: u64) -> bool {
        let is_new = self.overlay.borrow().is_none();
        if is_new {
            self.overlay.replace(Some(Overlay::new(limit)));
            self.media.iter_mut().for_each(|medium| medium.volume.inputs = inputs.clone());
        }
        is_new
    }

    /// Uncovers the media: changes go to the media again. Changes in memory must have been written, or are lost.
    pub(crate) fn uncover(&self) {
        self.overlay.replace(None);
    }

    /// The volume with a number.
    pub(super) fn volume(&self, number: usize) -> Option<&Volume> {
        self.media.iter().map(|medium| &medium.volume).find(|volume| volume.number == number)
    }

    /// Returns a copy of the changes in memory.
    pub(crate) fn overlay(&self) -> Option<Overlay> {
        self.overlay.borrow_mut().as_mut().map(Overlay::share)
    }

    /// Restores a copy of the changes.
    pub(crate) fn restore(&self, overlay: Option<Overlay>) {
        self.overlay.replace(overlay);
    }

    /// Whether a change was rejected since the last call, because all changes together would exceed the memory limit.
    pub(crate) fn take_overflow(&self) -> bool {
        self.overlay.borrow_mut().as_mut().is_some_and(Overlay::take_overflow)
    }

    /// Writes all changes in memory to the media. A file that another process has changed meanwhile stays unchanged.
    /// Returns the files that were not written, with the reason.
    pub fn write(&self) -> Vec<String> {
        let Some(overlay) = self.overlay() else { return Vec::new() };
        let volumes: Vec<(&str, &Volume)> =
            self.media.iter().map(|medium| (medium.name.as_str(), &medium.volume)).collect();
        overlay.write(&volumes)
    }

    /// Whether the path is the start folder of a medium, or a parent of it.
    pub(super) fn is_base(&self, place: &MountedPath<'_>) -> bool {
        let start = |medium: &MountedMedium| medium.start.iter().collect::<Utf8PathBuf>();
        self.media.iter().any(|medium| {
            std::ptr::eq(place.volume, &raw const medium.volume) && start(medium).starts_with(&place.path)
        })
    }
}

impl<'r> MountedPath<'r> {
    /// The kind of entry here.
    ///
    /// # Errors
    /// [`FileFault::BadPath`] if a link points out of the medium or the path cannot be inspected.
    pub fn kind(&self) -> Result<EntryKind, FileFault> {
        self.volume.kind(&self.path)
    }

    /// Returns the path of `name` in this folder, in any letter case. A name that does not exist keeps its spelling.
    ///
    /// # Errors
    /// [`FileFault::BadPath`] if this is a file, or a link points out of the medium.
    pub fn child(&self, name: &str) -> Result<Self, FileFault> {
        let exact = Self { volume: self.volume, path: self.path.join(name) };
        if exact.kind()? != EntryKind::Missing || self.kind()? == EntryKind::Missing {
            return Ok(exact);
        }
        let wanted = name.to_lowercase();
        let found = self.names()?.into_iter().find(|found| found.to_lowercase() == wanted);
        Ok(found.map_or(exact, |found| Self { volume: self.volume, path: self.path.join(found) }))
    }

    /// Resolves `path` relative to this folder, part by part as [`Self::child`].
    ///
    /// # Errors
    /// [`FileFault::BadPath`] for a path that is absolute or steps up, [`FileFault::BadName`] for reserved names, and as
    /// [`Self::child`].
    pub(super) fn child_path(&self, path: &Utf8Path) -> Result<Self, FileFault> {
        path.components().try_fold(self.clone(), |place, part| match part {
            Utf8Component::Normal(name) if is_reserved(name) => Err(FileFault::BadName),
            Utf8Component::Normal(name) => place.child(name),
            Utf8Component::CurDir => Ok(place),
            _ => Err(FileFault::BadPath),
        })
    }

    /// The names in this folder, sorted without regard to letter case.
    ///
    /// # Errors
    /// If the folder cannot be read. A name that is no text is skipped.
    pub fn names(&self) -> Result<Vec<String>, FileFault> {
        Ok(self.volume.names(&self.path)?)
    }

    /// Whether this folder contains a reserved name at any depth. Links are not followed, because a link itself is
    /// deleted and moved.
    ///
    /// # Errors
    /// If a folder cannot be read.
    pub(super) fn has_reserved(&self) -> Result<bool, FileFault> {
        for name in self.names()? {
            let inner = Self { volume: self.volume, path: self.path.join(&name) };
            if is_reserved(&name) {
                return Ok(true);
            }
            if !self.volume.is_link(&inner.path) && inner.kind()? == EntryKind::Folder && inner.has_reserved()? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The parent folder; the medium itself for its direct entries.
    #[must_use]
    pub fn parent(&self) -> Self {
        Self { volume: self.volume, path: self.path.parent().unwrap_or(Utf8Path::new("")).to_owned() }
    }

    /// The name here; empty for the medium itself.
    #[must_use]
    pub fn name(&self) -> &str {
        self.path.file_name().unwrap_or("")
    }

    /// The bytes of the file here.
    ///
    /// # Errors
    /// If the file cannot be read, or exceeds the size that a controller can store.
    pub fn read(&self) -> Result<Vec<u8>, FileFault> {
        Ok(self.volume.read(&self.path)?)
    }
}

#[cfg(test)]
mod tests;
