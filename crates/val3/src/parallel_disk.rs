//! The disk, with parallel reading of files, and with cached folder lists and paths.

use std::io;
use std::sync::{Mutex, PoisonError};

use camino::{Utf8Path, Utf8PathBuf};
use rayon::ThreadPool;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use val3_analysis::system::{DecodedFile, Disk, PathKind, System};
use val3_files::{FileClass, Unreadable};

/// View of the disk that reads files on several threads.
#[derive(Debug)]
pub(crate) struct ParallelDisk<'t> {
    /// Threads that read files.
    threads: &'t ThreadPool,
    /// Cached entries of folders, used first to find projects and then to load them.
    listed: Mutex<FxHashMap<Utf8PathBuf, Vec<String>>>,
    /// Cached kinds of paths: each project searches the folders above it for its repository and its cell.
    kinds: Mutex<FxHashMap<Utf8PathBuf, Option<PathKind>>>,
    /// Cached paths without links.
    targets: Mutex<FxHashMap<Utf8PathBuf, Utf8PathBuf>>,
}

impl<'t> ParallelDisk<'t> {
    /// Creates a view of the disk that reads on these threads.
    pub(crate) fn new(threads: &'t ThreadPool) -> Self {
        Self { threads, listed: Mutex::default(), kinds: Mutex::default(), targets: Mutex::default() }
    }
}

impl System for ParallelDisk<'_> {
    fn read(&self, path: &Utf8Path, class: FileClass) -> Result<Vec<u8>, Unreadable> {
        Disk.read(path, class)
    }

    fn read_all(&self, paths: &[Utf8PathBuf]) -> Vec<Option<DecodedFile>> {
        let read = |path: &Utf8PathBuf| DecodedFile::of(Disk.read(path, FileClass::Program));
        self.threads.install(|| paths.par_iter().with_min_len(8).map(read).collect())
    }

    fn size(&self, path: &Utf8Path) -> u64 {
        Disk.size(path)
    }

    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        let mut listed = self.listed.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(names) = listed.get(path) {
            return Ok(names.clone());
        }
        let names = Disk.list(path)?;
        listed.insert(path.to_owned(), names.clone());
        Ok(names)
    }

    fn kind(&self, path: &Utf8Path) -> Option<PathKind> {
        cached(&self.kinds, path, |path| Disk.kind(path))
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        self.target(path)
    }

    fn target(&self, path: &Utf8Path) -> Utf8PathBuf {
        cached(&self.targets, path, |path| Disk.target(path))
    }

    fn is_link(&self, path: &Utf8Path) -> bool {
        Disk.is_link(path)
    }
}

/// Returns the cached answer for a path, or computes it.
fn cached<T: Clone>(
    answers: &Mutex<FxHashMap<Utf8PathBuf, T>>,
    path: &Utf8Path,
    compute: impl FnOnce(&Utf8Path) -> T,
) -> T {
    let mut answers = answers.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(answer) = answers.get(path) {
        return answer.clone();
    }
    let answer = compute(path);
    answers.insert(path.to_owned(), answer.clone());
    answer
}
