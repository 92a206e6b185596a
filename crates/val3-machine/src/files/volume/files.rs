//! Open files on the disk or in the overlay above it.

use std::io::{self, BufReader, BufWriter, Read, Write};

use camino::Utf8Path;
use cap_std::fs_utf8::File;

use super::{SharedOverlay, Volume, relative};
use crate::files::overlay::{ContentReader, FileContent, FileId, OverlayItem};
use crate::files::{EntryKind, OpenMode};

/// File open for reading.
#[derive(Debug)]
pub(in crate::files) enum InFile {
    Disk(BufReader<File>),
    /// Content at the time of opening.
    Memory(ContentReader),
}

/// File open for writing.
#[derive(Debug)]
pub(in crate::files) enum OutFile {
    Disk(BufWriter<File>),
    Overlay(OverlayFile),
}

/// File of the overlay. Appended bytes can be read immediately.
#[derive(Debug, Clone)]
pub(in crate::files) struct OverlayFile {
    overlay: SharedOverlay,
    file: FileId,
}

impl Volume {
    /// Opens a file for reading.
    pub(in crate::files) fn open(&self, path: &Utf8Path) -> io::Result<InFile> {
        match self.is_covered() {
            false => Ok(InFile::Disk(BufReader::new(self.dir.open(relative(path))?))),
            true => Ok(InFile::Memory(self.content(path)?.reader())),
        }
    }

    /// Opens a file for writing, and creates it if it does not exist.
    pub(in crate::files) fn write(&self, path: &Utf8Path, mode: OpenMode) -> io::Result<OutFile> {
        if !self.is_covered() {
            let mut options = cap_std::fs::OpenOptions::new();
            match mode {
                OpenMode::Append => options.append(true).create(true),
                OpenMode::Read | OpenMode::Write => options.write(true).create(true).truncate(true),
            };
            return Ok(OutFile::Disk(BufWriter::new(self.dir.open_with(relative(path), &options)?)));
        }
        let known = self.node(path);
        let file = match (known, mode) {
            (Some(OverlayItem::File(file)), OpenMode::Append) => file,
            (Some(OverlayItem::File(file)), _) => {
                self.in_overlay(|overlay| overlay.truncate(file));
                file
            }
            (None, OpenMode::Append) if self.kind(path) == Ok(EntryKind::File) => {
                self.check_writable(path)?;
                self.capture(path)?
            }
            _ => self.put(path, FileContent::default())?,
        };
        Ok(OutFile::Overlay(OverlayFile { overlay: self.overlay.clone(), file }))
    }
}

impl InFile {
    /// Converts the file to a file in memory with the unread content.
    pub(in crate::files) fn into_memory(self) -> Self {
        match self {
            Self::Disk(mut file) => {
                let mut rest = Vec::new();
                // The readable part, as when the medium fails during reading.
                let _ = file.read_to_end(&mut rest);
                Self::Memory(FileContent::new(rest).reader())
            }
            Self::Memory(reader) => Self::Memory(reader),
        }
    }

    /// Returns the next byte; `None` at the end, or if the medium fails.
    pub(in crate::files) fn byte(&mut self) -> Option<u8> {
        match self {
            Self::Disk(file) => {
                let mut byte = [0];
                file.read_exact(&mut byte).ok().map(|()| byte[0])
            }
            Self::Memory(reader) => reader.next(),
        }
    }

    /// Returns a copy with the same position; `None` for a file on the disk.
    pub(in crate::files) fn copy(&self) -> Option<Self> {
        match self {
            Self::Disk(_) => None,
            Self::Memory(reader) => Some(Self::Memory(reader.clone())),
        }
    }
}

impl OutFile {
    /// Returns a copy; `None` for a file on the disk.
    pub(in crate::files) fn copy(&self) -> Option<Self> {
        match self {
            Self::Disk(_) => None,
            Self::Overlay(file) => Some(Self::Overlay(file.clone())),
        }
    }

    /// Writes the content to the physical medium, so that it survives a power cut.
    pub(in crate::files) fn sync_all(&mut self) -> io::Result<()> {
        match self {
            Self::Disk(file) => {
                file.flush()?;
                file.get_ref().sync_all()
            }
            Self::Overlay(_) => Ok(()),
        }
    }
}

impl Write for OutFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Disk(file) => file.write(bytes),
            Self::Overlay(OverlayFile { overlay, file }) => {
                overlay.borrow_mut().as_mut().map_or(Ok(()), |overlay| overlay.append(*file, bytes))?;
                Ok(bytes.len())
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Disk(file) => file.flush(),
            Self::Overlay(_) => Ok(()),
        }
    }
}
