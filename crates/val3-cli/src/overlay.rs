//! The disk, with texts laid over it that are not stored there.

use std::io::{self, Read as _};
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use rayon::ThreadPool;
use rustc_hash::FxHashMap;
use val3_analysis::db::path_key;
use val3_analysis::paths::normalise;
use val3_analysis::system::{Content, Kind, System};

use crate::opening::current_folder;
use crate::parallel_disk::ParallelDisk;
use crate::user_error::UserError;

/// A file that is read from the standard input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct StandardInput {
    /// Where it would lie: absolute, without `.` and `..`.
    pub(crate) path: Utf8PathBuf,
    /// What it holds.
    pub(crate) bytes: Vec<u8>,
}

impl StandardInput {
    /// Reads the standard input as the file at `path`.
    pub(crate) fn read(path: &Utf8Path) -> Result<Self, UserError> {
        let mut bytes = Vec::new();
        io::stdin()
            .read_to_end(&mut bytes)
            .map_err(|error| UserError::new(format!("cannot read the standard input: {error}")))?;
        Ok(Self { path: normalise(&current_folder()?.join(path)), bytes })
    }
}

/// Texts of files that were changed in memory, by path.
pub(crate) type EditedTexts = FxHashMap<Utf8PathBuf, Arc<str>>;

/// What the loader sees.
#[derive(Debug)]
pub(crate) struct OverlayFs<'a> {
    disk: ParallelDisk<'a>,
    input: Option<&'a StandardInput>,
    edited: &'a EditedTexts,
}

impl<'a> OverlayFs<'a> {
    /// The disk, read on these threads, below the standard input and the edited texts.
    pub(crate) fn new(threads: &'a ThreadPool, input: Option<&'a StandardInput>, edited: &'a EditedTexts) -> Self {
        Self { disk: ParallelDisk::new(threads), input, edited }
    }

    /// The standard input, if `path` means it.
    fn input_at(&self, path: &Utf8Path) -> Option<&'a StandardInput> {
        self.input.filter(|input| input.path == path || path_key(input.path.as_str()) == path_key(path.as_str()))
    }
}

impl System for OverlayFs<'_> {
    fn read(&self, path: &Utf8Path) -> io::Result<Vec<u8>> {
        self.input_at(path).map_or_else(|| self.disk.read(path), |input| Ok(input.bytes.clone()))
    }

    fn read_all(&self, paths: &[Utf8PathBuf]) -> Vec<Option<Content>> {
        let mut contents = self.disk.read_all(paths);
        for (path, content) in paths.iter().zip(&mut contents) {
            if let Some(input) = self.input_at(path) {
                *content = Content::of(Ok(input.bytes.clone()));
            }
        }
        contents
    }

    fn edited(&self, path: &Utf8Path) -> Option<Arc<str>> {
        self.edited.get(path).cloned()
    }

    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        let mut names = self.disk.list(path)?;
        let input = self.input.filter(|input| input.path.parent() == Some(path));
        let new = input.and_then(|input| input.path.file_name());
        if let Some(new) = new.filter(|new| !names.iter().any(|name| name.eq_ignore_ascii_case(new))) {
            names.push(new.to_owned());
            names.sort_unstable();
        }
        Ok(names)
    }

    fn kind(&self, path: &Utf8Path) -> Option<Kind> {
        if self.input_at(path).is_some() { Some(Kind::File) } else { self.disk.kind(path) }
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        self.disk.identity(path)
    }
}
