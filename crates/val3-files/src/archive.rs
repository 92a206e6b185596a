//! Unpacks ZIP archives of backups in memory, within limits.

use std::fmt;
use std::io::{BufReader, Cursor, Read, Seek, SeekFrom};

use camino::{Utf8Component, Utf8Path, Utf8PathBuf};
use zip::ZipArchive;

use crate::read::open_regular;
use crate::{FileClass, Unreadable};

/// Maximum number of entries.
const MOST_ENTRIES: usize = 65_536;

/// Maximum unpacked size of all files, in bytes.
const MOST_BYTES: u64 = 1 << 30;

/// Maximum compression ratio, far above the ratio of text.
const MOST_RATIO: u64 = 1_024;

/// Unpacked size in bytes up to which every compression ratio is accepted.
const ANY_SIZE: u64 = 1 << 20;

/// Signature of an entry, which is also the first signature of an archive.
const ENTRY_SIGNATURE: &[u8] = b"PK\x03\x04";

/// Signature of the record at the end of an archive.
const END_SIGNATURE: &[u8] = b"PK\x05\x06";

/// Maximum size of the record at the end of an archive, in bytes: 22 and the longest comment.
const MOST_END: u64 = 22 + 65_535;

/// Reason why an archive cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ArchiveFault {
    /// The archive file cannot be read.
    Unreadable(Unreadable),
    /// The file is no ZIP archive.
    NoArchive,
    /// The end of the archive, with its directory, is missing.
    CutOff,
    /// The directory of the archive is damaged.
    Damaged,
    /// An entry cannot be unpacked, because its bytes are damaged or compressed by an unsupported method.
    DamagedEntry(String),
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
    let archive = open(BufReader::new(file))?;
    let names = archive.file_names().collect::<Result<Vec<_>, _>>().map_err(|_| ArchiveFault::Damaged)?;
    let files = names.iter().map(|name| name.replace('\\', "/")).filter(|name| !name.ends_with('/'));
    Ok(files.map(Utf8PathBuf::from).collect())
}

/// Date and time of an entry's last change: year, month, day, hour, minute, second, in an unknown time zone.
pub type EntryDate = [u16; 6];

/// Dates of the files in the archive at `path`, by their paths in the archive. Only its directory is read.
///
/// # Errors
/// If the archive cannot be read, or has too many entries.
pub fn archive_dates(path: &Utf8Path) -> Result<Vec<(Utf8PathBuf, EntryDate)>, ArchiveFault> {
    let file = open_regular(path).map_err(ArchiveFault::Unreadable)?;
    let mut archive = open(BufReader::new(file))?;
    let mut dates = Vec::new();
    for index in 0..archive.len() {
        let raw = archive.by_index_raw(index).map_err(|_| ArchiveFault::Damaged)?;
        let Some(date) = raw.last_modified().filter(|_| !raw.is_dir()) else { continue };
        let name = inner_path(&raw.name().map_err(|_| ArchiveFault::Damaged)?)?;
        let [month, day, hour, minute, second] =
            [date.month(), date.day(), date.hour(), date.minute(), date.second()].map(u16::from);
        dates.push((name, [date.year(), month, day, hour, minute, second]));
    }
    Ok(dates)
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
    let mut archive = open(Cursor::new(bytes.as_slice()))?;
    let mut files = Vec::new();
    let mut left = MOST_BYTES;
    for index in 0..archive.len() {
        let raw = archive.by_index_raw(index).map_err(|_| ArchiveFault::Damaged)?;
        if raw.is_dir() {
            continue;
        }
        let name = inner_path(&raw.name().map_err(|_| ArchiveFault::Damaged)?)?;
        if !wanted(&name) {
            continue;
        }
        if raw.encrypted() {
            return Err(ArchiveFault::Encrypted(name.into_string()));
        }
        let most = left.min(raw.compressed_size().saturating_mul(MOST_RATIO).max(ANY_SIZE));
        drop(raw);
        let damaged = || ArchiveFault::DamagedEntry(name.to_string());
        let mut content = Vec::new();
        let entry = archive.by_index(index).map_err(|_| damaged())?;
        entry.take(most.saturating_add(1)).read_to_end(&mut content).map_err(|_| damaged())?;
        left = match u64::try_from(content.len()) {
            Ok(size) if size <= most => left.saturating_sub(size),
            _ => return Err(ArchiveFault::TooLarge),
        };
        files.push((name, content));
    }
    Ok(files)
}

/// Opens an archive and reads its directory.
fn open<R: Read + Seek>(mut reader: R) -> Result<ZipArchive<R>, ArchiveFault> {
    let fault = fault_without_directory(&mut reader).map_err(|error| ArchiveFault::Unreadable(error.into()))?;
    let archive = ZipArchive::new(reader).map_err(|_| fault)?;
    if archive.len() > MOST_ENTRIES { Err(ArchiveFault::TooLarge) } else { Ok(archive) }
}

/// Fault of a file without a readable directory, determined from the signatures at its start and end.
fn fault_without_directory(reader: &mut (impl Read + Seek)) -> std::io::Result<ArchiveFault> {
    let mut begin = Vec::new();
    reader.by_ref().take(4).read_to_end(&mut begin)?;
    let size = reader.seek(SeekFrom::End(0))?;
    reader.seek(SeekFrom::Start(size.saturating_sub(MOST_END)))?;
    let mut end = Vec::new();
    reader.read_to_end(&mut end)?;
    reader.rewind()?;
    let has_end = end.windows(END_SIGNATURE.len()).any(|part| part == END_SIGNATURE);
    Ok(match (has_end, begin == ENTRY_SIGNATURE) {
        (true, _) => ArchiveFault::Damaged,
        (false, true) => ArchiveFault::CutOff,
        (false, false) => ArchiveFault::NoArchive,
    })
}

/// Converts an entry's name to a path, which must be inside the archive. Some tools write backslashes.
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
            Self::NoArchive => f.write_str("it is no ZIP archive"),
            Self::CutOff => f.write_str("the end of the ZIP archive is missing; copy it again"),
            Self::Damaged => f.write_str("the directory of the ZIP archive is damaged; copy it again"),
            Self::DamagedEntry(name) => {
                write!(f, "`{name}` in it cannot be unpacked: it is damaged, or compressed by an unusual method")
            }
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
        assert_eq!(archive_entries(&path), Err(ArchiveFault::NoArchive));
        assert_eq!(archive_entries(&folder), Err(ArchiveFault::Unreadable(Unreadable::Folder)));
    }

    #[test]
    fn the_dates_of_an_archive_are_listed() {
        let (_kept, folder) = folder();
        let path = folder.join("backup.zip");
        let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
        let date = zip::DateTime::from_date_and_time(2021, 1, 5, 8, 30, 2).unwrap();
        writer.add_directory("log", SimpleFileOptions::default()).unwrap();
        writer.start_file("log/user.log", SimpleFileOptions::default().last_modified_time(date)).unwrap();
        std::fs::write(&path, writer.finish().unwrap().into_inner()).unwrap();
        assert_eq!(archive_dates(&path).unwrap(), [("log/user.log".into(), [2021, 1, 5, 8, 30, 2])]);
        assert_eq!(archive_dates(&folder), Err(ArchiveFault::Unreadable(Unreadable::Folder)));
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
        assert_eq!(unpack(&path, |_| true), Err(ArchiveFault::NoArchive));
        assert_eq!(unpack(&folder, |_| true), Err(ArchiveFault::Unreadable(Unreadable::Folder)));
    }

    #[test]
    fn an_archive_that_is_cut_off_anywhere_is_no_archive_or_has_no_end() {
        let (_kept, folder) = folder();
        let path = packed(&folder, &[("a.pjx", b"some text"), ("b.pgx", b"more text")]);
        let bytes = std::fs::read(&path).unwrap();
        for length in 0..bytes.len() {
            std::fs::write(&path, &bytes[..length]).unwrap();
            // If the cut is within the record at the end, its signature still exists, so the archive counts as damaged.
            let fault = match length {
                0..4 => ArchiveFault::NoArchive,
                _ if length + 18 < bytes.len() => ArchiveFault::CutOff,
                _ => ArchiveFault::Damaged,
            };
            assert_eq!(unpack(&path, |_| true), Err(fault), "{length} of {} bytes", bytes.len());
        }
    }

    #[test]
    fn the_damaged_entry_is_named() {
        let (_kept, folder) = folder();
        let path = packed(&folder, &[("a.pjx", b"some text"), ("b.pgx", b"more text")]);
        let mut bytes = std::fs::read(&path).unwrap();
        // After the local header of the first entry (30 bytes) and its name.
        bytes[30 + "a.pjx".len()] ^= 0xff;
        std::fs::write(&path, bytes).unwrap();
        assert_eq!(unpack(&path, |_| true), Err(ArchiveFault::DamagedEntry("a.pjx".to_owned())));
    }
}
