//! Writes files to a medium so that after a crash at any step all files are old or all are new.
//!
//! All new files are written and synced in a folder `.saving` inside of the library's folder. The new library is valid
//! as soon as that folder is renamed to `.saved`: its files are then moved into place, the project file last. The next
//! access after a crash moves the remaining files.

use std::io::{self, Write};

use camino::{Utf8Path, Utf8PathBuf};

use super::{EntryKind, FileFault, LibraryFile, MountedPath, has_extension};
use crate::files::OpenMode;

/// Folder of files that are being written.
const SAVING: &str = ".saving";

/// Folder of complete files, which are valid.
const SAVED: &str = ".saved";

/// Called before each step that changes the medium: a test ends the work there, like a crash or a full disk.
pub trait Steps {
    /// Begins the next step.
    ///
    /// # Errors
    /// Ends the work with this error.
    fn next(&mut self) -> io::Result<()>;
}

/// Steps without an interruption.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Uninterrupted;

impl Steps for Uninterrupted {
    fn next(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Writes the files of a library into its folder, which is created if it is missing.
pub(super) fn store(folder: &MountedPath<'_>, files: &[LibraryFile], steps: &mut dyn Steps) -> Result<(), FileFault> {
    recover(folder, steps)?;
    let made = folder.kind()? == EntryKind::Missing;
    let written = write_all(folder, files, steps);
    if let Err(fault) = written {
        return Err(clear_away(folder, made, steps).err().unwrap_or(fault));
    }
    steps.next()?;
    folder.volume.rename(&folder.path.join(SAVING), folder.volume, &folder.path.join(SAVED))?;
    folder.volume.sync(&folder.path)?;
    roll_forward(folder, steps)
}

fn write_all(folder: &MountedPath<'_>, files: &[LibraryFile], steps: &mut dyn Steps) -> Result<(), FileFault> {
    let saving = MountedPath { volume: folder.volume, path: folder.path.join(SAVING) };
    steps.next()?;
    folder.volume.create_dir_all(&saving.path)?;
    for file in files {
        let path = saving.path.join(&file.path);
        steps.next()?;
        folder.volume.create_dir_all(path.parent().unwrap_or(&saving.path))?;
        steps.next()?;
        let mut open = folder.volume.write(&path, OpenMode::Write)?;
        let (half, rest) = file.bytes.split_at(file.bytes.len() / 2);
        open.write_all(half)?;
        steps.next()?;
        open.write_all(rest)?;
        steps.next()?;
        open.sync_all()?;
    }
    Ok(saving.volume.sync(&saving.path)?)
}

/// Removes the files of a failed save. An error means that the medium rejects the removal; otherwise the caller returns
/// the fault of the save.
fn clear_away(folder: &MountedPath<'_>, made: bool, steps: &mut dyn Steps) -> Result<(), FileFault> {
    let saving = MountedPath { volume: folder.volume, path: folder.path.join(SAVING) };
    if saving.kind()? == EntryKind::Folder {
        steps.next()?;
        folder.volume.remove_dir_all(&saving.path)?;
    }
    if made && folder.kind()? == EntryKind::Folder {
        steps.next()?;
        folder.volume.remove_dir(&folder.path)?;
    }
    Ok(())
}

/// Completes a save that a crash has interrupted.
pub(super) fn recover(folder: &MountedPath<'_>, steps: &mut dyn Steps) -> Result<(), FileFault> {
    let inside = |name: &str| MountedPath { volume: folder.volume, path: folder.path.join(name) };
    if inside(SAVED).kind()? == EntryKind::Folder {
        roll_forward(folder, steps)?;
    }
    if inside(SAVING).kind()? == EntryKind::Folder {
        steps.next()?;
        folder.volume.remove_dir_all(&folder.path.join(SAVING))?;
    }
    Ok(())
}

/// Moves the valid files into place, the project file last.
fn roll_forward(folder: &MountedPath<'_>, steps: &mut dyn Steps) -> Result<(), FileFault> {
    let saved = MountedPath { volume: folder.volume, path: folder.path.join(SAVED) };
    let mut files = Vec::new();
    collect(&saved, Utf8Path::new(""), &mut files)?;
    files.sort_by_key(|path| (has_extension(path, "pjx"), path.clone()));
    for file in &files {
        let target = folder.child_path(file)?;
        steps.next()?;
        folder.volume.create_dir_all(&target.parent().path)?;
        steps.next()?;
        folder.volume.rename(&saved.path.join(file), folder.volume, &target.path)?;
        folder.volume.sync(&target.parent().path)?;
    }
    steps.next()?;
    folder.volume.remove_dir_all(&saved.path)?;
    Ok(folder.volume.sync(&folder.path)?)
}

/// Collects the files below `at`, as paths relative to `top`.
fn collect(top: &MountedPath<'_>, at: &Utf8Path, files: &mut Vec<Utf8PathBuf>) -> Result<(), FileFault> {
    for name in (MountedPath { volume: top.volume, path: top.path.join(at) }).names()? {
        let path = at.join(name);
        match (MountedPath { volume: top.volume, path: top.path.join(&path) }).kind()? {
            EntryKind::Folder => collect(top, &path, files)?,
            EntryKind::File => files.push(path),
            EntryKind::Missing => {}
        }
    }
    Ok(())
}

/// Deletes the files of a library, the project file first, and then the empty folders.
pub(super) fn delete(folder: &MountedPath<'_>, files: &[LibraryFile]) -> Result<(), FileFault> {
    for file in files {
        folder.volume.remove_file(&folder.path.join(&file.path))?;
    }
    let around = files.iter().filter_map(|file| file.path.parent());
    // Without the separator at the end, which results from joining an empty path.
    let around = around.map(|around| folder.path.join(around).components().collect::<Utf8PathBuf>());
    let mut folders: Vec<_> = around.filter(|path| path.as_str() != "").collect();
    folders.sort_by_key(|path| (std::cmp::Reverse(path.components().count()), path.clone()));
    folders.dedup();
    for path in folders {
        let place = MountedPath { volume: folder.volume, path };
        if place.kind()? == EntryKind::Folder && place.names()?.is_empty() {
            folder.volume.remove_dir(&place.path)?;
        }
    }
    Ok(())
}
