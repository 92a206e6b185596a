//! Open files: the instructions of the file add-on that read and write lines and bytes.

use std::collections::VecDeque;
use std::io::Write;

use camino::Utf8PathBuf;

use super::volume::{InFile, OutFile};
use super::{ControllerPath, EntryKind, FileFault, Roots};
use crate::string_bytes::fill;

/// Maximum number of open files.
const MOST: usize = 10;

/// Number of bytes skipped in one step in a line without text.
const PASSED: usize = 4_096;

/// The files that a controller has open, by number.
#[derive(Debug, Default)]
pub struct OpenFiles {
    files: [Option<OpenFile>; MOST],
}

/// The access that a file is opened for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum OpenMode {
    /// `"r"`.
    Read,
    /// `"w"`: the previous content is lost.
    Write,
    /// `"a"`: text is written after the previous content.
    Append,
}

#[derive(Debug)]
enum OpenFile {
    Reading(FileReading),
    Writing(Writing),
}

#[derive(Debug)]
struct Writing {
    file: OutFile,
    volume: usize,
    path: Utf8PathBuf,
}

#[derive(Debug)]
struct FileReading {
    file: InFile,
    /// Bytes that were inspected but not read.
    ahead: VecDeque<u8>,
}

impl OpenMode {
    /// Parses the mode, in any letter case; a final `b` or `t` has no effect.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        match text.trim().to_ascii_lowercase().trim_end_matches(['b', 't']) {
            "r" => Some(Self::Read),
            "w" => Some(Self::Write),
            "a" => Some(Self::Append),
            _ => None,
        }
    }
}

impl OpenFiles {
    /// Opens a file and returns its number, 0 to 9 (`$fileOpen`).
    ///
    /// # Errors
    /// [`FileFault::Medium`] if ten files are open, or the error of the path or the medium.
    pub fn open(&mut self, roots: &Roots, path: &ControllerPath, mode: OpenMode) -> Result<usize, FileFault> {
        let number = self.files.iter().position(Option::is_none).ok_or(FileFault::Medium)?;
        let place = roots.place(path)?;
        if place.kind()? == EntryKind::Folder {
            return Err(FileFault::BadPath);
        }
        let open = match mode {
            OpenMode::Read => {
                OpenFile::Reading(FileReading { file: place.volume.open(&place.path)?, ahead: VecDeque::new() })
            }
            OpenMode::Write | OpenMode::Append => OpenFile::Writing(Writing {
                file: place.volume.write(&place.path, mode)?,
                volume: place.volume.number,
                path: place.path,
            }),
        };
        if let Some(slot) = self.files.get_mut(number) {
            *slot = Some(open);
        }
        Ok(number)
    }

    /// Reads at most `most` lines, fewer at the end of the file (`$fileGet`). A file that is not open for reading has
    /// no lines. A line that is longer than a string continues in the next string.
    pub fn lines(&mut self, number: usize, most: usize) -> Vec<String> {
        let Some(reading) = self.reading(number) else { return Vec::new() };
        std::iter::from_fn(|| reading.line()).take(most).collect()
    }

    /// Reads at most `most` bytes, fewer at the end of the file. A file that is not open for reading has no bytes.
    pub fn bytes(&mut self, number: usize, most: usize) -> Vec<u8> {
        let Some(reading) = self.reading(number) else { return Vec::new() };
        std::iter::from_fn(|| reading.byte()).take(most).collect()
    }

    /// Writes lines, each with a line end, and returns their number (`$fileSet`). Other instructions can read them
    /// immediately.
    pub fn write_lines<'t>(&mut self, number: usize, lines: impl IntoIterator<Item = &'t str>) -> usize {
        let Some(file) = self.writing(number) else { return 0 };
        let written = lines.into_iter().take_while(|line| writeln!(file, "{line}").is_ok()).count();
        if file.flush().is_ok() { written } else { 0 }
    }

    /// Writes bytes and returns their number.
    pub fn write_bytes(&mut self, number: usize, bytes: &[u8]) -> usize {
        let Some(file) = self.writing(number) else { return 0 };
        if file.write_all(bytes).and_then(|()| file.flush()).is_ok() { bytes.len() } else { 0 }
    }

    /// Closes a file, after which everything written is on the medium (`$fileClose`).
    ///
    /// # Errors
    /// [`FileFault::NotFound`] if no such file is open, or the error of the medium; the file is closed then.
    pub fn close(&mut self, number: usize) -> Result<(), FileFault> {
        match self.files.get_mut(number).and_then(Option::take).ok_or(FileFault::NotFound)? {
            OpenFile::Reading(_) => Ok(()),
            OpenFile::Writing(mut writing) => Ok(writing.file.flush()?),
        }
    }

    /// Redirects later writes to the overlay that now covers the media, or to the uncovered media.
    pub(crate) fn follow(&mut self, roots: &Roots) {
        for slot in &mut self.files {
            *slot = slot.take().and_then(|open| open.following(roots));
        }
    }

    /// Returns a copy of the files with their positions, in memory.
    pub(crate) fn copy(&self) -> Self {
        Self { files: std::array::from_fn(|number| self.files.get(number)?.as_ref()?.copy()) }
    }

    fn reading(&mut self, number: usize) -> Option<&mut FileReading> {
        match self.files.get_mut(number)? {
            Some(OpenFile::Reading(reading)) => Some(reading),
            _ => None,
        }
    }

    fn writing(&mut self, number: usize) -> Option<&mut OutFile> {
        match self.files.get_mut(number)? {
            Some(OpenFile::Writing(writing)) => Some(&mut writing.file),
            _ => None,
        }
    }
}

impl OpenFile {
    /// Returns the file at the current destination for changes, or with the remaining content in memory; `None` if the
    /// medium fails or no longer contains the file.
    fn following(self, roots: &Roots) -> Option<Self> {
        match self {
            Self::Reading(FileReading { file, ahead }) => {
                Some(Self::Reading(FileReading { file: file.into_memory(), ahead }))
            }
            Self::Writing(Writing { mut file, volume, path }) => {
                file.flush().ok()?;
                let medium = roots.volume(volume)?;
                let is_there = medium.kind(&path) == Ok(EntryKind::File);
                let file = is_there.then(|| medium.write(&path, OpenMode::Append))?.ok()?;
                Some(Self::Writing(Writing { file, volume, path }))
            }
        }
    }

    fn copy(&self) -> Option<Self> {
        match self {
            Self::Reading(FileReading { file, ahead }) => {
                Some(Self::Reading(FileReading { file: file.copy()?, ahead: ahead.clone() }))
            }
            Self::Writing(Writing { file, volume, path }) => {
                Some(Self::Writing(Writing { file: file.copy()?, volume: *volume, path: path.clone() }))
            }
        }
    }
}

impl FileReading {
    /// Returns the next byte; `None` at the end, or if the medium fails.
    fn byte(&mut self) -> Option<u8> {
        self.ahead.pop_front().or_else(|| self.file.byte())
    }

    /// Whether these bytes are next.
    fn accepts_bytes(&mut self, bytes: &[u8]) -> bool {
        while self.ahead.len() < bytes.len() {
            let Some(byte) = self.file.byte() else { return false };
            self.ahead.push_back(byte);
        }
        self.ahead.iter().take(bytes.len()).eq(bytes)
    }

    /// Skips the end of the line if it is next. Returns whether it was.
    fn end_line(&mut self) -> bool {
        let end = [&b"\n"[..], b"\r\n"].into_iter().find(|end| self.accepts_bytes(end));
        self.ahead.drain(..end.map_or(0, <[u8]>::len));
        end.is_some()
    }

    /// Returns the next line, or the part of the line that fits a string. The end of a line that fills its string
    /// exactly is read together with the line.
    fn line(&mut self) -> Option<String> {
        let mut bytes = Vec::new();
        loop {
            if self.end_line() {
                return Some(fill(&bytes).text);
            }
            let Some(byte) = self.byte() else { return (!bytes.is_empty()).then(|| fill(&bytes).text) };
            bytes.push(byte);
            let filled = fill(&bytes);
            if filled.full {
                let rest = bytes.split_off(filled.used);
                rest.into_iter().rev().for_each(|byte| self.ahead.push_front(byte));
                self.end_line();
                return Some(filled.text);
            }
            if bytes.len() > PASSED {
                bytes = filled.text.into_bytes();
            }
        }
    }
}

#[cfg(test)]
mod tests;
