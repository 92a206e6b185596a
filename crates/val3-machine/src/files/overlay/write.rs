//! Writes an overlay's changes to the disk.
//!
//! New content is written first and deletions follow, so that an interruption loses nothing. Each file is written under
//! a temporary name and then renamed, so that it is complete at any time.

use std::collections::BTreeMap;
use std::io::{self, Write as _};

use camino::{Utf8Path, Utf8PathBuf};
use cap_std::fs_utf8::Dir;

use super::{DiskState, FileContent, Overlay, OverlayItem, OverlayNode, OverlayPath};
use crate::files::volume::{Volume, relative};

/// Suffix of a file that is written next to a file of the same name, because the file on the disk must stay.
const BESIDE: &str = ".debugged";

/// Remaining changes.
type Rest<'o> = BTreeMap<&'o OverlayPath, &'o OverlayNode>;

impl Overlay {
    /// Writes all changes and returns the failures with their reasons. `volumes` contains the volumes with the names of
    /// their media.
    pub(in crate::files) fn write(&self, volumes: &[(&str, &Volume)]) -> Vec<String> {
        let mut messages = Vec::new();
        let mut rest: Rest<'_> = self.entries.iter().collect();
        for pass in [Pass::Write, Pass::Delete, Pass::Exchange] {
            self.pass(volumes, &mut rest, pass, &mut messages);
        }
        for place in rest.into_keys() {
            let [medium, path] = shown(volumes, place);
            messages.push(format!("cannot write `{medium}://{path}`: something else is there on the disk"));
        }
        messages
    }

    fn pass(&self, volumes: &[(&str, &Volume)], rest: &mut Rest<'_>, pass: Pass, messages: &mut Vec<String>) {
        let places = rest.iter().filter(|(_, entry)| (entry.now == OverlayItem::Missing) == (pass == Pass::Delete));
        let mut places: Vec<(&OverlayPath, &OverlayNode)> = places.map(|(place, entry)| (*place, *entry)).collect();
        if pass == Pass::Delete {
            // The contents of a folder are deleted before the folder.
            places.reverse();
        }
        for (place, entry) in places {
            let Some(volume) = volumes.iter().map(|(_, volume)| *volume).find(|volume| volume.number == place.0) else {
                continue;
            };
            if pass == Pass::Exchange {
                make_room(&volume.dir, &place.1, entry);
            }
            let done = match entry.now {
                OverlayItem::Missing if self.is_spelled_otherwise(&volume.dir, place) => Ok(Done::Whole),
                OverlayItem::Missing => delete(&volume.dir, &place.1, entry.disk),
                OverlayItem::Folder => make_folder(&volume.dir, &place.1),
                OverlayItem::File(file) => put(&volume.dir, &place.1, entry.disk, &self.content(file)),
            };
            let [medium, path] = shown(volumes, place);
            match done {
                Ok(Done::Blocked) => continue,
                Ok(Done::Whole) => {}
                Ok(Done::Beside(name)) => messages.push(format!(
                    "`{medium}://{path}` was changed on the disk after the program had changed it, and stays as it is: \
                     the file of the program is `{name}` next to it"
                )),
                Ok(Done::Kept) => messages.push(format!(
                    "`{medium}://{path}` was changed on the disk after the program had deleted it, and stays"
                )),
                Err(error) => messages.push(format!("cannot change `{medium}://{path}`: {error}")),
            }
            rest.remove(place);
        }
    }

    /// Whether the disk ignores letter case and has an entry of the program under another spelling.
    fn is_spelled_otherwise(&self, dir: &Dir, (volume, path): &OverlayPath) -> bool {
        let state = DiskState::of(dir, path);
        if state == DiskState::Folder && dir.read_dir(path).is_ok_and(|mut names| names.next().is_none()) {
            return false;
        }
        let spelling = path.as_str().to_lowercase();
        let mut others = self.entries.iter().filter(|(_, entry)| entry.now != OverlayItem::Missing);
        others.any(|((number, other), _)| {
            number == volume && other.as_str().to_lowercase() == spelling && DiskState::of(dir, other) == state
        })
    }
}

/// Pass of writing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pass {
    /// Files and folders, except at paths with an entry of the other kind.
    Write,
    Delete,
    /// Files in place of folders, and folders in place of files.
    Exchange,
}

/// Result of writing one entry.
enum Done {
    /// The disk has the program's state.
    Whole,
    /// Another entry has to be deleted first.
    Blocked,
    /// Another process has changed the file. The program's file was written under this name.
    Beside(String),
    /// Another process has changed the file that the program has deleted.
    Kept,
}

fn shown<'v>(volumes: &[(&'v str, &Volume)], (number, path): &'v OverlayPath) -> [&'v str; 2] {
    let medium = volumes.iter().find(|(_, volume)| volume.number == *number).map_or("", |(name, _)| *name);
    [medium, path.as_str()]
}

fn delete(dir: &Dir, path: &Utf8Path, before: DiskState) -> io::Result<Done> {
    let now = DiskState::of(dir, path);
    match now {
        // A link to a file that does not exist.
        DiskState::Missing if dir.symlink_metadata(path).is_ok() => dir.remove_file(path).map(|()| Done::Whole),
        DiskState::Missing => Ok(Done::Whole),
        DiskState::File(..) if now != before => Ok(Done::Kept),
        DiskState::File(..) => dir.remove_file(path).map(|()| Done::Whole),
        DiskState::Folder => match dir.remove_dir(path) {
            // A file in the folder is new or has changed.
            Err(error) if error.kind() == io::ErrorKind::DirectoryNotEmpty => Ok(Done::Kept),
            // A link to a folder is a file for the system.
            Err(error) if error.kind() == io::ErrorKind::NotADirectory => dir.remove_file(path).map(|()| Done::Whole),
            removed => removed.map(|()| Done::Whole),
        },
    }
}

/// Deletes an entry that the program has replaced by an entry of a different kind. A failure blocks the path, which is
/// then reported.
fn make_room(dir: &Dir, path: &Utf8Path, entry: &OverlayNode) {
    let is_left = DiskState::of(dir, path) == entry.disk;
    let _ = match (entry.disk, entry.now) {
        (DiskState::File(..), OverlayItem::Folder) if is_left => dir.remove_file(path),
        (DiskState::Folder, OverlayItem::File(_)) => dir.remove_dir(path),
        _ => Ok(()),
    };
}

fn make_folder(dir: &Dir, path: &Utf8Path) -> io::Result<Done> {
    match DiskState::of(dir, path) {
        DiskState::Folder => Ok(Done::Whole),
        DiskState::File(..) => Ok(Done::Blocked),
        DiskState::Missing if is_blocked(dir, path) => Ok(Done::Blocked),
        DiskState::Missing => dir.create_dir(path).map(|()| Done::Whole),
    }
}

fn put(dir: &Dir, path: &Utf8Path, before: DiskState, content: &FileContent) -> io::Result<Done> {
    let now = DiskState::of(dir, path);
    match now {
        DiskState::Folder => return Ok(Done::Blocked),
        DiskState::Missing if is_blocked(dir, path) => return Ok(Done::Blocked),
        // If the file was deleted meanwhile, no content can be lost.
        DiskState::Missing => replace(dir, path, content)?,
        DiskState::File(..) if is_same(dir, path, content)? => {}
        DiskState::File(..) if now == before => replace(dir, path, content)?,
        DiskState::File(..) => {
            let beside = Utf8PathBuf::from(format!("{path}{BESIDE}"));
            replace(dir, &beside, content)?;
            return Ok(Done::Beside(beside.file_name().unwrap_or_default().to_owned()));
        }
    }
    Ok(Done::Whole)
}

/// Whether the parent folder of a path does not exist yet.
fn is_blocked(dir: &Dir, path: &Utf8Path) -> bool {
    path.parent().is_some_and(|around| DiskState::of(dir, around) != DiskState::Folder)
}

fn is_same(dir: &Dir, path: &Utf8Path, content: &FileContent) -> io::Result<bool> {
    Ok(dir.metadata(path)?.len() == content.bytes() && dir.read(path)? == content.to_vec())
}

/// Writes a file with the permissions of the replaced file. A link stays a link.
fn replace(dir: &Dir, path: &Utf8Path, content: &FileContent) -> io::Result<()> {
    let path = dir.canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let name = format!(".{}.writing", path.file_name().unwrap_or_default());
    let temporary = path.with_file_name(name);
    let written = write_as(dir, &temporary, &path, content);
    if written.is_err() && dir.exists(&temporary) {
        dir.remove_file(&temporary)?;
    }
    written
}

fn write_as(dir: &Dir, temporary: &Utf8Path, path: &Utf8Path, content: &FileContent) -> io::Result<()> {
    let mut file = dir.create(temporary)?;
    content.pieces().try_for_each(|piece| file.write_all(piece))?;
    if let Ok(old) = dir.metadata(path) {
        file.set_permissions(old.permissions())?;
    }
    file.sync_all()?;
    drop(file);
    dir.rename(temporary, dir, relative(path))
}
