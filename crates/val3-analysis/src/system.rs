//! File system interface of the loader, with implementations for the disk, for memory, and for an overlay.

mod links;
mod overlay;

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::io;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use val3_files::{FileClass, Unreadable};
use val3_syntax::encoding::decode;
use val3_syntax::foreign::ForeignContent;

use crate::db::FileStatus;
use crate::paths::normalise;

pub use overlay::OverlayFs;

/// Kind of path target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathKind {
    /// A file.
    File,
    /// A folder.
    Folder,
}

/// A file system as the loader uses it.
pub trait System: Send + Sync + Debug {
    /// Reads a file up to the size limit of the class.
    ///
    /// # Errors
    /// If the path is no file of this size, or the file system cannot read it.
    fn read(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable>;

    /// Reads several program, data or project files, in the same order; `None` if a file does not exist. An
    /// implementation may read them in parallel.
    fn read_all(&self, paths: &[Utf8PathBuf]) -> Vec<Option<DecodedFile>> {
        paths.iter().map(|path| DecodedFile::of(self.read(path, FileClass::Program))).collect()
    }

    /// Returns the text of a file that is open in an editor, which takes precedence over the stored text.
    fn edited(&self, _path: &Utf8Path) -> Option<Arc<str>> {
        None
    }

    /// Reads the stored bytes of a program, data or project file, even if the file is open in an editor.
    ///
    /// # Errors
    /// As for [`read`](Self::read).
    fn stored(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable> {
        self.read(path, class)
    }

    /// Returns the size of a stored file in bytes; 0 if it does not exist.
    fn size(&self, path: &Utf8Path) -> u64;

    /// Returns the sorted names of a folder's entries, without names that are not valid UTF-8.
    ///
    /// # Errors
    /// If the file system cannot list the folder.
    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>>;

    /// Returns the kind of `path` after following links; `None` if it does not exist.
    fn kind(&self, path: &Utf8Path) -> Option<PathKind>;

    /// Returns a path that is unique for a folder, so that circular links are recognised.
    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf;

    /// Resolves all links in the path. The last parts need not exist.
    fn target(&self, path: &Utf8Path) -> Utf8PathBuf {
        normalise(path)
    }

    /// Whether the entry at `path` is itself a link.
    fn is_link(&self, _path: &Utf8Path) -> bool {
        false
    }
}

impl<S: System + ?Sized> System for &S {
    fn read(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable> {
        (**self).read(path, class)
    }

    fn read_all(&self, paths: &[Utf8PathBuf]) -> Vec<Option<DecodedFile>> {
        (**self).read_all(paths)
    }

    fn edited(&self, path: &Utf8Path) -> Option<Arc<str>> {
        (**self).edited(path)
    }

    fn stored(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable> {
        (**self).stored(path, class)
    }

    fn size(&self, path: &Utf8Path) -> u64 {
        (**self).size(path)
    }

    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        (**self).list(path)
    }

    fn kind(&self, path: &Utf8Path) -> Option<PathKind> {
        (**self).kind(path)
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        (**self).identity(path)
    }

    fn target(&self, path: &Utf8Path) -> Utf8PathBuf {
        (**self).target(path)
    }

    fn is_link(&self, path: &Utf8Path) -> bool {
        (**self).is_link(path)
    }
}

/// Content of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DecodedFile {
    /// Decoded text; empty if the file is unreadable.
    pub text: Arc<str>,
    /// Result of reading; `None` if the text comes from an editor.
    pub status: Option<FileStatus>,
}

/// Maximum file size in bytes: offsets have 32 bits.
const SIZE_LIMIT: usize = u32::MAX as usize / 2;

impl DecodedFile {
    /// Converts the result of reading to content; `None` if the file does not exist.
    pub fn of(read: Result<Vec<u8>, Unreadable>) -> Option<Self> {
        match read {
            Ok(bytes) if bytes.len() > SIZE_LIMIT => Some(Self::unreadable("it is larger than 2 GiB".to_owned())),
            Ok(bytes) => {
                if let Some(foreign) = ForeignContent::of(&bytes) {
                    return Some(Self::unreadable(foreign.to_string()));
                }
                let decoded = decode(bytes);
                let status = FileStatus::Read { encoding: decoded.encoding, mismatch: decoded.mismatch };
                Some(Self { text: decoded.text.into(), status: Some(status) })
            }
            Err(Unreadable::Missing) => None,
            Err(reason) => Some(Self::unreadable(reason.to_string())),
        }
    }

    /// Creates the content for an unreadable file.
    pub(crate) fn unreadable(reason: String) -> Self {
        Self { text: "".into(), status: Some(FileStatus::Unreadable(reason)) }
    }
}

/// The file system of the operating system.
#[derive(Debug, Clone, Copy, Default)]
pub struct Disk;

impl System for Disk {
    fn read(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable> {
        val3_files::read(path, class)
    }

    fn size(&self, path: &Utf8Path) -> u64 {
        std::fs::metadata(path).map_or(0, |metadata| metadata.len())
    }

    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        let mut names: Vec<String> =
            path.read_dir_utf8()?.filter_map(Result::ok).map(|entry| entry.file_name().to_owned()).collect();
        names.sort_unstable();
        Ok(names)
    }

    fn kind(&self, path: &Utf8Path) -> Option<PathKind> {
        let metadata = std::fs::metadata(path).ok()?;
        Some(if metadata.is_dir() { PathKind::Folder } else { PathKind::File })
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        path.canonicalize_utf8().unwrap_or_else(|_| path.to_owned())
    }

    fn target(&self, path: &Utf8Path) -> Utf8PathBuf {
        links::target(path)
    }

    fn is_link(&self, path: &Utf8Path) -> bool {
        path.is_symlink()
    }
}

/// A file system in memory.
#[derive(Debug, Clone, Default)]
pub struct Memory {
    files: BTreeMap<Utf8PathBuf, Vec<u8>>,
}

impl Memory {
    /// Creates a file system with these files.
    pub fn new<P: Into<Utf8PathBuf>, B: Into<Vec<u8>>>(files: impl IntoIterator<Item = (P, B)>) -> Self {
        Self { files: files.into_iter().map(|(path, bytes)| (path.into(), bytes.into())).collect() }
    }
}

impl System for Memory {
    fn read(&self, path: &Utf8Path, _class: FileClass) -> Result<Vec<u8>, Unreadable> {
        self.files.get(path).cloned().ok_or(Unreadable::Missing)
    }

    fn size(&self, path: &Utf8Path) -> u64 {
        self.files.get(path).map_or(0, |bytes| bytes.len().try_into().unwrap_or(u64::MAX))
    }

    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        let mut names: Vec<String> = self
            .files
            .keys()
            .filter_map(|file| file.strip_prefix(path).ok()?.components().next().map(|part| part.as_str().to_owned()))
            .collect();
        names.sort_unstable();
        names.dedup();
        if names.is_empty() { Err(io::ErrorKind::NotFound.into()) } else { Ok(names) }
    }

    fn kind(&self, path: &Utf8Path) -> Option<PathKind> {
        if self.files.contains_key(path) {
            return Some(PathKind::File);
        }
        self.files.keys().any(|file| file.starts_with(path)).then_some(PathKind::Folder)
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        path.to_owned()
    }
}
