//! ZIP archives of backups, unpacked in memory within limits.

use std::fmt;
use std::io::{BufReader, Cursor, Read as _};

use camino::{Utf8Component, Utf8Path, Utf8PathBuf};
use zip::ZipArchive;
use zip::result::ZipError;

use crate::read::open_regular;
use crate::{FileClass, Unreadable};

/// Maximum number of entries.
const MOST_ENTRIES: usize = 65_536;

/// Limit of the unpacked size of all files, in bytes.
const MOST_BYTES: u64 = 1 << 30;

/// Limit of the compression ratio, far above the ratio of text.
const MOST_RATIO: u64 = 1_024;

/// Unpacked size that is accepted for any compression ratio, in bytes.
const ANY_SIZE: u64 = 1 << 20;

/// Reason why an archive cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ArchiveFault {
    /// The archive file cannot be read.
    Unreadable(Unreadable),
    /// The file is no ZIP archive, or is damaged.
    Damaged(String),
    /// The archive has too many entries, or their unpacked size is too large.
    TooLarge,
    /// An entry is encrypted.
    Encrypted(String),
    /// An entry's name refers to a path outside the archive.
    Outside(String),
}

/// Whether the path has the extension of a ZIP archive.
pub fn is_archive_name(path: &Utf8Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("zip"))
}

/// Paths of the files in the archive at `path`. Only its directory is read.
///
/// # Errors
/// If the archive cannot be read, or has too many entries.
pub fn archive_entries(path: &Utf8Path) -> Result<Vec<Utf8PathBuf>, ArchiveFault> {
    let file = open_regular(path).map_err(ArchiveFault::Unreadable)?;
    let archive = ZipArchive::new(BufReader::new(file)).map_err(|error| damaged(&error))?;
    if archive.len() > MOST_ENTRIES {
        return Err(ArchiveFault::TooLarge);
    }
    let names = archive.file_names().collect::<Result<Vec<_>, _>>().map_err(|error| damaged(&error))?;
    let files = names.iter().map(|name| name.replace('\\', "/")).filter(|name| !name.ends_with('/'));
    Ok(files.map(Utf8PathBuf::from).collect())
}

/// Files in the archive at `path` for which `wanted` returns true, by their paths in the archive.
///
/// # Errors
/// If the archive cannot be read, or exceeds the limits.
pub fn unpack(
    path: &Utf8Path,
    mut wanted: impl FnMut(&Utf8Path) -> bool,
) -> Result<Vec<(Utf8PathBuf, Vec<u8>)>, ArchiveFault> {
    let bytes = crate::read(path, FileClass::Record).map_err(ArchiveFault::Unreadable)?;
    let mut archive = ZipArchive::new(Cursor::new(bytes.as_slice())).map_err(|error| damaged(&error))?;
    if archive.len() > MOST_ENTRIES {
        return Err(ArchiveFault::TooLarge);
    }
    let mut files = Vec::new();
    let mut left = MOST_BYTES;
    for index in 0..archive.len() {
        let raw = archive.by_index_raw(index).map_err(|error| damaged(&error))?;
        if raw.is_dir() {
            continue;
        }
        let name = inner_path(&raw.name().map_err(|error| damaged(&error))?)?;
        if !wanted(&name) {
            continue;
        }
        if raw.encrypted() {
            return Err(ArchiveFault::Encrypted(name.into_string()));
        }
        let most = left.min(raw.compressed_size().saturating_mul(MOST_RATIO).max(ANY_SIZE));
        drop(raw);
        let mut content = Vec::new();
        let entry = archive.by_index(index).map_err(|error| damaged(&error))?;
        let read = entry.take(most.saturating_add(1)).read_to_end(&mut content);
        read.map_err(|error| ArchiveFault::Damaged(error.to_string()))?;
        left = match u64::try_from(content.len()) {
            Ok(size) if size <= most => left.saturating_sub(size),
            _ => return Err(ArchiveFault::TooLarge),
        };
        files.push((name, content));
    }
    Ok(files)
}

fn damaged(error: &ZipError) -> ArchiveFault {
    ArchiveFault::Damaged(error.to_string())
}

/// Entry path, which must be inside the archive. Some tools write backslashes.
fn inner_path(name: &str) -> Result<Utf8PathBuf, ArchiveFault> {
    let slashed = name.replace('\\', "/");
    let path = Utf8Path::new(&slashed);
    let is_inside = path.components().all(|part| matches!(part, Utf8Component::Normal(_) | Utf8Component::CurDir));
    if is_inside && !slashed.is_empty() && !slashed.contains([':', '\0']) {
        Ok(path.components().collect())
    } else {
        Err(ArchiveFault::Outside(name.to_owned()))
    }
}

impl fmt::Display for ArchiveFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable(reason) => reason.fmt(f),
            Self::Damaged(reason) => write!(f, "it is no ZIP archive, or a damaged one: {reason}"),
            Self::TooLarge => f.write_str("it has more entries, or unpacks to more bytes, than a backup; unpack it"),
            Self::Encrypted(name) => write!(f, "`{name}` in it is encrypted; unpack it"),
            Self::Outside(name) => write!(f, "`{name}` resolves to a path outside the archive"),
        }
    }
}

impl std::error::Error for ArchiveFault {}

#[cfg(test)]
mod tests {
    use std::io::Write as _;

    use zip::write::{SimpleFileOptions, ZipWriter};

    use super::*;
    use crate::testing::folder;

    fn packed(folder: &Utf8Path, entries: &[(&str, &[u8])]) -> Utf8PathBuf {
        let path = folder.join("backup.zip");
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        for (name, bytes) in entries {
            writer.start_file(*name, SimpleFileOptions::default()).unwrap();
            writer.write_all(bytes).unwrap();
        }
        std::fs::write(&path, writer.finish().unwrap().into_inner()).unwrap();
        path
    }

    fn unpacked(entries: &[(&str, &[u8])]) -> Result<Vec<(Utf8PathBuf, Vec<u8>)>, ArchiveFault> {
        let (_kept, folder) = folder();
        let path = packed(&folder, entries);
        unpack(&path, |name| name.extension() != Some("log"))
    }

    #[test]
    fn the_wanted_files_are_unpacked() {
        let files = unpacked(&[("usr/usrapp/a/a.pjx", b"a"), ("usr\\b.pgx", b"b"), ("log/x.log", b"x")]).unwrap();
        assert_eq!(files, [("usr/usrapp/a/a.pjx".into(), b"a".to_vec()), ("usr/b.pgx".into(), b"b".to_vec())]);
    }

    #[test]
    fn the_entries_of_an_archive_are_listed_without_their_content() {
        let (_kept, folder) = folder();
        let path = packed(&folder, &[("usr/usrapp/a/a.pjx", b"a"), ("usr\\b.pgx", b"b"), ("../c.pgx", b"c")]);
        assert_eq!(archive_entries(&path).unwrap(), ["usr/usrapp/a/a.pjx", "usr/b.pgx", "../c.pgx"]);
        std::fs::write(&path, "text").unwrap();
        assert!(matches!(archive_entries(&path), Err(ArchiveFault::Damaged(_))));
        assert_eq!(archive_entries(&folder), Err(ArchiveFault::Unreadable(Unreadable::Folder)));
    }

    #[test]
    fn names_that_lead_outside_and_bombs_are_refused() {
        for name in ["../a.pgx", "/a.pgx", "C:/a.pgx", "a/../../b.pgx"] {
            assert_eq!(unpacked(&[(name, b"")]), Err(ArchiveFault::Outside(name.to_owned())), "{name}");
        }
        assert_eq!(unpacked(&[("a.pgx", &vec![0; 8 << 20])]), Err(ArchiveFault::TooLarge));
    }

    #[test]
    fn what_is_no_archive_is_named() {
        let (_kept, folder) = folder();
        let path = folder.join("a.zip");
        std::fs::write(&path, "text").unwrap();
        let error = unpack(&path, |_| true).unwrap_err();
        assert!(error.to_string().starts_with("it is no ZIP archive, or a damaged one: "), "{error}");
        assert_eq!(unpack(&folder, |_| true), Err(ArchiveFault::Unreadable(Unreadable::Folder)));
    }
}
