//! The file system as the loader sees it: the real one, one in memory, or one with files laid over it.

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

/// The kind of a path's target.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A file.
    File,
    /// A folder.
    Folder,
}

/// The interface of a file system that the loader uses.
pub trait System: Send + Sync + Debug {
    /// The bytes of a file, up to the limit of its class.
    ///
    /// # Errors
    /// The path is not that of a file of this size, or the file system cannot read it.
    fn read(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable>;

    /// The contents of several programs, data files or projects, in the same order; `None` where there is no file. An implementation may read them
    /// in parallel.
    fn read_all(&self, paths: &[Utf8PathBuf]) -> Vec<Option<Content>> {
        paths.iter().map(|path| Content::of(self.read(path, FileClass::Program))).collect()
    }

    /// The text of a file that is being edited, which counts instead of the stored one.
    fn edited(&self, _path: &Utf8Path) -> Option<Arc<str>> {
        None
    }

    /// The stored bytes of a program, data file or project, even while it is being edited.
    ///
    /// # Errors
    /// Those of [`read`](Self::read).
    fn stored(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable> {
        self.read(path, class)
    }

    /// The size of a stored file in bytes; 0 if it does not exist.
    fn size(&self, path: &Utf8Path) -> u64;

    /// Names of the entries of a folder, sorted. Names that are no UTF-8 are left out.
    ///
    /// # Errors
    /// Those of the file system.
    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>>;

    /// The kind of `path`, after following links; `None` where there is nothing.
    fn kind(&self, path: &Utf8Path) -> Option<Kind>;

    /// A path that is the same for every way to the same folder, so that links cannot lead around in circles.
    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf;

    /// The path after following all links, of which the last names need not exist.
    fn target(&self, path: &Utf8Path) -> Utf8PathBuf {
        normalise(path)
    }

    /// Whether the entry at `path` itself is a link.
    fn is_link(&self, _path: &Utf8Path) -> bool {
        false
    }
}

impl<S: System + ?Sized> System for &S {
    fn read(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable> {
        (**self).read(path, class)
    }

    fn read_all(&self, paths: &[Utf8PathBuf]) -> Vec<Option<Content>> {
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

    fn kind(&self, path: &Utf8Path) -> Option<Kind> {
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

/// The content of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Content {
    /// Its text; empty where it cannot be read.
    pub text: Arc<str>,
    /// How it was read; `None` where an editor has the text.
    pub status: Option<FileStatus>,
}

/// The largest file that is read, in bytes: offsets have 32 bits.
const SIZE_LIMIT: usize = u32::MAX as usize / 2;

impl Content {
    /// The content of what was read; `None` where there is no file.
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

    /// The content of a file that cannot be read.
    pub(crate) fn unreadable(reason: String) -> Self {
        Self { text: "".into(), status: Some(FileStatus::Unreadable(reason)) }
    }
}

/// The disk.
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

    fn kind(&self, path: &Utf8Path) -> Option<Kind> {
        let metadata = std::fs::metadata(path).ok()?;
        Some(if metadata.is_dir() { Kind::Folder } else { Kind::File })
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

/// Files in memory.
#[derive(Debug, Clone, Default)]
pub struct Memory {
    files: BTreeMap<Utf8PathBuf, Vec<u8>>,
}

impl Memory {
    /// A file system with these files.
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

    fn kind(&self, path: &Utf8Path) -> Option<Kind> {
        if self.files.contains_key(path) {
            return Some(Kind::File);
        }
        self.files.keys().any(|file| file.starts_with(path)).then_some(Kind::Folder)
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        path.to_owned()
    }
}
