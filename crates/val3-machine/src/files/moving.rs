//! Instructions of the file add-on that copy, move and delete entire files and folders.

use std::io;

use super::reserved::is_reserved;
use super::{ControllerPath, EntryKind, FileFault, MountedPath, Roots};

/// Whether a file exists (`$fileExists`). A folder is no file.
///
/// # Errors
/// If the path cannot be resolved.
pub fn file_exists(roots: &Roots, path: &ControllerPath) -> Result<bool, FileFault> {
    Ok(roots.place(path)?.kind()? == EntryKind::File)
}

/// Deletes a file, or a folder with its content (`$delete`).
///
/// # Errors
/// [`FileFault::NotFound`] if nothing exists at the path, [`FileFault::BadName`] for a medium itself,
/// [`FileFault::ReadOnly`] for a folder that contains a reserved name, and the errors of the medium.
pub fn delete(roots: &Roots, path: &ControllerPath) -> Result<(), FileFault> {
    let place = movable(roots, path)?;
    match place.kind()? {
        EntryKind::Missing => Err(FileFault::NotFound),
        EntryKind::File => Ok(place.volume.remove_file(&place.path)?),
        EntryKind::Folder => {
            check_free(&place)?;
            Ok(place.volume.remove_dir_all(&place.path)?)
        }
    }
}

/// Checks that a folder can be deleted or moved: it contains no reserved name.
fn check_free(folder: &MountedPath<'_>) -> Result<(), FileFault> {
    if folder.has_reserved()? { Err(FileFault::ReadOnly) } else { Ok(()) }
}

/// Copies a file, which replaces an existing file, or a folder with its content without reserved names (`$copy`).
///
/// # Errors
/// [`FileFault::NotFound`] if nothing exists at the path, [`FileFault::BadPath`] for a copy onto itself or into itself,
/// onto a folder, or into a missing folder, and the errors of the medium. No partial copy remains then.
pub fn copy(roots: &Roots, from: &ControllerPath, to: &ControllerPath) -> Result<(), FileFault> {
    let (from, to) = (movable(roots, from)?, movable(roots, to)?);
    let kind = from.kind()?;
    if kind == EntryKind::Missing {
        return Err(FileFault::NotFound);
    }
    let there = to.kind()?;
    let onto = kind == EntryKind::Folder && there != EntryKind::Missing || there == EntryKind::Folder;
    if onto || is_inside(&to, &from) || to.parent().kind()? != EntryKind::Folder {
        return Err(FileFault::BadPath);
    }
    copy_all(&from, &to, kind)
}

/// Moves or renames a file or a folder (`$rename`). A move to another medium is a copy followed by a deletion.
///
/// # Errors
/// [`FileFault::NotFound`] if nothing exists at the path, [`FileFault::BadPath`] if the new path exists already, or is
/// inside of the folder itself or of a missing folder, [`FileFault::ReadOnly`] for a folder that contains a reserved
/// name, and the errors of the medium.
pub fn rename(roots: &Roots, from: &ControllerPath, to: &ControllerPath) -> Result<(), FileFault> {
    let name = to.name().ok_or(FileFault::BadName)?;
    let (from, to) = (movable(roots, from)?, movable(roots, to)?);
    let kind = from.kind()?;
    if kind == EntryKind::Missing {
        return Err(FileFault::NotFound);
    }
    let same = is_same(&from, &to);
    if !same && (to.kind()? != EntryKind::Missing || is_inside(&to, &from)) {
        return Err(FileFault::BadPath);
    }
    if to.parent().kind()? != EntryKind::Folder {
        return Err(FileFault::BadPath);
    }
    if kind == EntryKind::Folder {
        check_free(&from)?;
    }
    // A name that differs only in letter case gets the new spelling.
    let target = to.parent().path.join(name);
    match from.volume.rename(&from.path, to.volume, &target) {
        Err(error) if error.kind() == io::ErrorKind::CrossesDevices => {
            copy_all(&from, &to, kind)?;
            match kind {
                EntryKind::Folder => Ok(from.volume.remove_dir_all(&from.path)?),
                _ => Ok(from.volume.remove_file(&from.path)?),
            }
        }
        done => Ok(done?),
    }
}

/// Resolves a path that may be moved or deleted: not a medium itself.
fn movable<'r>(roots: &'r Roots, path: &ControllerPath) -> Result<MountedPath<'r>, FileFault> {
    let place = roots.place(path)?;
    if roots.is_base(&place) { Err(FileFault::BadName) } else { Ok(place) }
}

fn is_same(one: &MountedPath<'_>, other: &MountedPath<'_>) -> bool {
    std::ptr::eq(one.volume, other.volume) && one.path == other.path
}

fn is_inside(inner: &MountedPath<'_>, outer: &MountedPath<'_>) -> bool {
    std::ptr::eq(inner.volume, outer.volume) && inner.path.starts_with(&outer.path)
}

fn copy_all(from: &MountedPath<'_>, to: &MountedPath<'_>, kind: EntryKind) -> Result<(), FileFault> {
    if kind == EntryKind::File {
        return match from.volume.copy(&from.path, to.volume, &to.path) {
            Ok(()) => Ok(()),
            Err(error) => {
                to.volume.remove_file(&to.path)?;
                Err(error.into())
            }
        };
    }
    let copied = copy_folder(from, to);
    if copied.is_err() && to.kind()? == EntryKind::Folder {
        to.volume.remove_dir_all(&to.path)?;
    }
    copied
}

fn copy_folder(from: &MountedPath<'_>, to: &MountedPath<'_>) -> Result<(), FileFault> {
    let names = from.names()?;
    to.volume.create_dir(&to.path)?;
    for name in names.into_iter().filter(|name| !is_reserved(name)) {
        let inner = from.child(&name)?;
        let target = MountedPath { volume: to.volume, path: to.path.join(&name) };
        match inner.kind()? {
            EntryKind::Folder => copy_folder(&inner, &target)?,
            kind => copy_all(&inner, &target, kind)?,
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
