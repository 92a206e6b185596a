//! Encrypted libraries: a library's folder as a ZIP archive with the classic encryption (6.5).
//!
//! On a controller the public password is computed from the archive's password by an unknown method. Here both
//! passwords are the same.

use std::io::{Cursor, Read};

use camino::{Utf8Component, Utf8Path, Utf8PathBuf};
use zip::result::ZipError;
use zip::{CompressionMethod, ZipArchive};

use super::{FileFault, LibraryFile, has_extension};

/// Maximum number of files in an archive; libraries have fewer.
const MOST_FILES: usize = 4_096;

/// Maximum unpacked archive size in bytes.
const MOST_BYTES: u64 = 64 << 20;

/// Maximum compression ratio; text has a far lower ratio.
const MOST_RATIO: u64 = 1_024;

/// Unpacked size in bytes that is allowed for every entry, independent of the packed size.
const ANY_SIZE: u64 = 1 << 20;

/// Unpacks an archive in memory, the project file first.
///
/// # Errors
/// [`FileFault::NotEncrypted`] if the bytes are no ZIP archive or an entry is not encrypted with the classic
/// encryption, [`FileFault::CannotLoad`] if the password is wrong, or if the archive is damaged, contains no library,
/// exceeds the maximum size, or contains a name outside of the folder.
pub fn unpack(bytes: &[u8], password: &str) -> Result<Vec<LibraryFile>, FileFault> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|_| FileFault::NotEncrypted)?;
    if archive.len() > MOST_FILES {
        return Err(FileFault::CannotLoad);
    }
    let mut files = Vec::new();
    let mut left = MOST_BYTES;
    for index in 0..archive.len() {
        let file = entry(&mut archive, index, password, &mut left)?;
        files.extend(file);
    }
    project_first(files)
}

fn entry(
    archive: &mut ZipArchive<Cursor<&[u8]>>,
    index: usize,
    password: &str,
    left: &mut u64,
) -> Result<Option<LibraryFile>, FileFault> {
    let raw = archive.by_index_raw(index).map_err(|error| fault(&error))?;
    if raw.is_dir() {
        return Ok(None);
    }
    if !raw.encrypted() || raw.compression() == CompressionMethod::AES {
        return Err(FileFault::NotEncrypted);
    }
    let path = path(&raw.name().map_err(|error| fault(&error))?)?;
    let most = (*left).min(raw.compressed_size().saturating_mul(MOST_RATIO).max(ANY_SIZE));
    drop(raw);
    let entry = archive.by_index_decrypt(index, password.as_bytes()).map_err(|error| fault(&error))?;
    let mut bytes = Vec::new();
    entry.take(most + 1).read_to_end(&mut bytes).map_err(|_| FileFault::CannotLoad)?;
    let size = u64::try_from(bytes.len()).unwrap_or(u64::MAX);
    if size > most {
        return Err(FileFault::CannotLoad);
    }
    *left -= size;
    Ok(Some(LibraryFile { path, bytes }))
}

fn fault(error: &ZipError) -> FileFault {
    match error {
        ZipError::UnsupportedArchive(_) | ZipError::CompressionMethodNotSupported(_) => FileFault::NotEncrypted,
        _ => FileFault::CannotLoad,
    }
}

/// Returns an entry's path, which stays in its folder.
fn path(name: &str) -> Result<Utf8PathBuf, FileFault> {
    let name = name.replace('\\', "/");
    let path = Utf8Path::new(&name);
    let inside = path.components().all(|part| matches!(part, Utf8Component::Normal(_) | Utf8Component::CurDir));
    let odd = name.contains([':', '\0']) || name.is_empty();
    if inside && !odd { Ok(path.components().collect()) } else { Err(FileFault::CannotLoad) }
}

/// Returns the files of the folder with the project file. Some tools pack the folder itself, other tools its content.
fn project_first(mut files: Vec<LibraryFile>) -> Result<Vec<LibraryFile>, FileFault> {
    let projects = files.iter().filter(|file| has_extension(&file.path, "pjx"));
    let project = projects.min_by_key(|file| file.path.components().count()).ok_or(FileFault::CannotLoad)?;
    let folder = project.path.parent().unwrap_or(Utf8Path::new("")).to_owned();
    let project = project.path.clone();
    files.retain(|file| file.path.starts_with(&folder));
    files.sort_by_key(|file| file.path != project);
    for file in &mut files {
        file.path = file.path.strip_prefix(&folder).unwrap_or(&file.path).to_owned();
    }
    Ok(files)
}

#[cfg(test)]
mod tests;
