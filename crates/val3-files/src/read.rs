//! Reads regular files up to their class limit.

use std::fs::{self, File};
use std::io::{Read, Seek as _, SeekFrom};

use camino::Utf8Path;

use crate::{FileClass, Unreadable};

/// Reads a regular file. Links are followed.
///
/// # Errors
/// If the path is not a regular file, if the file exceeds its class limit, or if the system cannot read it.
pub fn read(path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable> {
    let file = open_regular(path)?;
    let (size, limit) = (file.metadata()?.len(), class.limit());
    if size > limit {
        return Err(Unreadable::TooLarge { bytes: Some(size), limit });
    }
    read_stream(file, class)
}

/// Reads the first bytes of a regular file, at most `count`.
///
/// # Errors
/// If the path is not a regular file, or if the system cannot read it.
pub fn read_head(path: &Utf8Path, count: u64) -> Result<Vec<u8>, Unreadable> {
    let mut bytes = Vec::new();
    open_regular(path)?.take(count).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Reads a regular file from an offset to its end. If the file is shorter, it was replaced, and it is read from its
/// start. Returns the offset from which it was read, and the bytes.
///
/// # Errors
/// Like [`read`]; the limit applies to the bytes from the offset on.
pub fn read_from(path: &Utf8Path, offset: u64, class: FileClass) -> Result<(u64, Vec<u8>), Unreadable> {
    let mut file = open_regular(path)?;
    let offset = if file.metadata()?.len() < offset { 0 } else { offset };
    file.seek(SeekFrom::Start(offset))?;
    Ok((offset, read_stream(file, class)?))
}

/// Reads a regular file as UTF-8 text.
///
/// # Errors
/// Like [`read`], and [`Unreadable::NotUtf8`].
pub fn read_text(path: &Utf8Path, class: FileClass) -> Result<String, Unreadable> {
    String::from_utf8(read(path, class)?).map_err(|_| Unreadable::NotUtf8)
}

/// Reads a stream to its end, for example the standard input.
///
/// # Errors
/// If the stream has more bytes than the limit of the class, or cannot be read.
pub fn read_stream(stream: impl Read, class: FileClass) -> Result<Vec<u8>, Unreadable> {
    let limit = class.limit();
    let mut bytes = Vec::new();
    stream.take(limit.saturating_add(1)).read_to_end(&mut bytes)?;
    match u64::try_from(bytes.len()) {
        Ok(length) if length <= limit => Ok(bytes),
        _ => Err(Unreadable::TooLarge { bytes: None, limit }),
    }
}

/// Opens a regular file. The type is checked before opening, because opening some devices has an effect. It is checked
/// again afterwards, because the path may have been replaced meanwhile.
pub(crate) fn open_regular(path: &Utf8Path) -> Result<File, Unreadable> {
    check_type(&fs::metadata(path)?)?;
    let file = open(path)?;
    check_type(&file.metadata()?)?;
    Ok(file)
}

fn check_type(metadata: &fs::Metadata) -> Result<(), Unreadable> {
    Unreadable::of_type(metadata.file_type()).map_or(Ok(()), Err)
}

/// Opens a file without waiting for the other end of a pipe.
#[cfg(unix)]
fn open(path: &Utf8Path) -> std::io::Result<File> {
    use std::os::unix::fs::OpenOptionsExt as _;

    use rustix::fs::OFlags;
    let flags = (OFlags::NONBLOCK | OFlags::NOCTTY).bits();
    File::options().read(true).custom_flags(flags.cast_signed()).open(path)
}

#[cfg(not(unix))]
fn open(path: &Utf8Path) -> std::io::Result<File> {
    File::open(path)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::testing::folder;

    fn reason(path: &Utf8Path) -> String {
        read(path, FileClass::Settings).unwrap_err().to_string()
    }

    #[test]
    fn a_regular_file_is_read_up_to_its_limit() {
        let (_kept, folder) = folder();
        let path = folder.join("a.toml");
        fs::write(&path, vec![b' '; 1 << 20]).unwrap();
        assert_eq!(read(&path, FileClass::Settings).unwrap().len(), 1 << 20);
        File::options().write(true).open(&path).unwrap().set_len((1 << 20) + 1).unwrap();
        expect!["it has 1048577 bytes, and at most 1048576 bytes are read; --max-file-size raises the limit"]
            .assert_eq(&reason(&path));
        assert_eq!(read(&path, FileClass::Cell).unwrap().len(), (1 << 20) + 1);
    }

    #[test]
    fn a_file_is_read_from_an_offset_and_a_shorter_one_from_its_start() {
        let (_kept, folder) = folder();
        let path = folder.join("user.log");
        fs::write(&path, "first\nsecond\n").unwrap();
        assert_eq!(read_from(&path, 6, FileClass::Record), Ok((6, b"second\n".to_vec())));
        assert_eq!(read_from(&path, 13, FileClass::Record), Ok((13, Vec::new())));
        fs::write(&path, "new\n").unwrap();
        assert_eq!(read_from(&path, 13, FileClass::Record), Ok((0, b"new\n".to_vec())));
    }

    #[test]
    fn an_endless_stream_is_read_up_to_the_limit() {
        let error = read_stream(std::io::repeat(0), FileClass::Settings).unwrap_err();
        expect!["it grows while it is read, and at most 1048576 bytes are read; --max-file-size raises the limit"]
            .assert_eq(&error.to_string());
    }

    #[test]
    fn a_folder_and_a_missing_file_are_named() {
        let (_kept, folder) = folder();
        assert_eq!(reason(&folder), "it is a folder");
        assert_eq!(read(&folder.join("none"), FileClass::Settings), Err(Unreadable::Missing));
    }

    #[test]
    fn a_text_is_utf8() {
        let (_kept, folder) = folder();
        fs::write(folder.join("a"), b"\xff").unwrap();
        assert_eq!(read_text(&folder.join("a"), FileClass::Settings), Err(Unreadable::NotUtf8));
    }

    /// None of these files may be opened for reading: a pipe waits for its other end, and a device has no end.
    #[cfg(target_os = "linux")]
    #[test]
    fn pipes_sockets_and_devices_are_refused_at_once() {
        let (_kept, folder) = folder();
        let (pipe, socket, link) = (folder.join("pipe"), folder.join("socket"), folder.join("link.pgx"));
        rustix::fs::mknodat(rustix::fs::CWD, pipe.as_std_path(), rustix::fs::FileType::Fifo, 0o600.into(), 0).unwrap();
        let _listener = std::os::unix::net::UnixListener::bind(&socket).unwrap();
        std::os::unix::fs::symlink("/dev/zero", &link).unwrap();
        assert_eq!(reason(&pipe), "it is a pipe");
        assert_eq!(reason(&socket), "it is a socket");
        assert_eq!(reason(&link), "it is a device");
    }
}
