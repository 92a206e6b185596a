//! Folders of the user: listing, creation, and removal and renaming of files.

use std::fs;
use std::io;

use camino::{Utf8Path, Utf8PathBuf};

use crate::{Unreadable, Unwritable};

/// Entry of a folder. Symbolic links are not followed.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct FolderEntry {
    /// Name without a folder.
    pub name: String,
    /// Type of the entry.
    pub kind: FolderEntryKind,
}

/// Type of a folder's entry.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum FolderEntryKind {
    /// A regular file.
    File,
    /// A folder.
    Folder,
    /// A symbolic link, device, pipe or socket.
    Special,
}

/// Returns the entries of a folder, sorted by name.
///
/// # Errors
/// If the folder cannot be read, or a name is not UTF-8.
pub fn list_folder(folder: &Utf8Path) -> Result<Vec<FolderEntry>, Unreadable> {
    let mut entries = fs::read_dir(folder)?.map(|entry| folder_entry(&entry?)).collect::<Result<Vec<_>, _>>()?;
    entries.sort();
    Ok(entries)
}

fn folder_entry(entry: &fs::DirEntry) -> Result<FolderEntry, Unreadable> {
    let name = entry.file_name().into_string();
    let name = name.map_err(|name| Unreadable::NameNotUtf8(name.to_string_lossy().into_owned()))?;
    let ty = entry.file_type()?;
    let kind = match ty {
        ty if ty.is_file() => FolderEntryKind::File,
        ty if ty.is_dir() => FolderEntryKind::Folder,
        _ => FolderEntryKind::Special,
    };
    Ok(FolderEntry { name, kind })
}

/// Creates a folder with its parent folders. An existing folder is no error.
///
/// # Errors
/// If a folder cannot be created.
pub fn create_folders(folder: &Utf8Path) -> Result<(), Unwritable> {
    Ok(fs::create_dir_all(folder)?)
}

/// Creates one folder, which does not exist.
///
/// # Errors
/// If the folder exists, its parent folder does not exist, or it cannot be created.
pub fn create_folder(folder: &Utf8Path) -> Result<(), Unwritable> {
    Ok(fs::create_dir(folder)?)
}

/// Removes a file.
///
/// # Errors
/// If the path does not exist, is a folder, or cannot be removed.
pub fn remove_file(path: &Utf8Path) -> Result<(), Unwritable> {
    Ok(fs::remove_file(path)?)
}

/// Removes an empty folder.
///
/// # Errors
/// If the folder is not empty, does not exist, or cannot be removed.
pub fn remove_folder(path: &Utf8Path) -> Result<(), Unwritable> {
    Ok(fs::remove_dir(path)?)
}

/// Removes a folder with its content. A folder that does not exist is no error. Symbolic links in it are removed, not
/// followed.
///
/// # Errors
/// If the folder or a part of it cannot be removed.
pub fn remove_tree(path: &Utf8Path) -> Result<(), Unwritable> {
    match fs::remove_dir_all(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        removed => Ok(removed?),
    }
}

/// Renames a file. An existing file with the new name is replaced.
///
/// # Errors
/// If the file does not exist or cannot be renamed.
pub fn rename_file(from: &Utf8Path, to: &Utf8Path) -> Result<(), Unwritable> {
    Ok(fs::rename(from, to)?)
}

/// Nearest folder, from `start` upwards, that contains the file `name`.
#[must_use]
pub fn folder_with(start: &Utf8Path, name: &Utf8Path) -> Option<Utf8PathBuf> {
    start.ancestors().find(|folder| folder.join(name).is_file()).map(Utf8Path::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::folder;

    #[test]
    fn entries_are_sorted_and_links_are_not_followed() {
        let (_kept, folder) = folder();
        create_folders(&folder.join("b/c")).unwrap();
        fs::write(folder.join("a"), "").unwrap();
        #[cfg(unix)]
        std::os::unix::fs::symlink("b", folder.join("c")).unwrap();
        let entry = |name: &str, kind| FolderEntry { name: name.to_owned(), kind };
        let mut expected = vec![entry("a", FolderEntryKind::File), entry("b", FolderEntryKind::Folder)];
        if cfg!(unix) {
            expected.push(entry("c", FolderEntryKind::Special));
        }
        assert_eq!(list_folder(&folder).unwrap(), expected);
        assert_eq!(list_folder(&folder.join("none")), Err(Unreadable::Missing));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_name_that_is_not_utf8_is_named() {
        use std::os::unix::ffi::OsStrExt as _;
        let (_kept, folder) = folder();
        fs::write(folder.as_std_path().join(std::ffi::OsStr::from_bytes(b"Gr\xfcn.pgx")), "").unwrap();
        assert_eq!(list_folder(&folder), Err(Unreadable::NameNotUtf8("Gr\u{fffd}n.pgx".to_owned())));
    }

    #[test]
    fn only_an_empty_folder_is_removed_alone() {
        let (_kept, folder) = folder();
        create_folder(&folder.join("a")).unwrap();
        fs::write(folder.join("a/x"), "").unwrap();
        remove_folder(&folder.join("a")).unwrap_err();
        rename_file(&folder.join("a/x"), &folder.join("y")).unwrap();
        remove_folder(&folder.join("a")).unwrap();
        remove_file(&folder.join("y")).unwrap();
        remove_tree(&folder.join("none")).unwrap();
        assert_eq!(list_folder(&folder), Ok(Vec::new()));
    }

    #[test]
    fn the_nearest_folder_with_a_file_is_found_upwards() {
        let (_kept, folder) = folder();
        create_folders(&folder.join("a/b")).unwrap();
        fs::write(folder.join("mark"), "").unwrap();
        assert_eq!(folder_with(&folder.join("a/b"), "mark".into()), Some(folder.clone()));
        assert_eq!(folder_with(&folder, "none".into()), None);
    }
}
