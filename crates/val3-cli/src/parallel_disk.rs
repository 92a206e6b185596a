//! The disk, with many files read side by side.

use std::io;

use camino::{Utf8Path, Utf8PathBuf};
use rayon::ThreadPool;
use rayon::prelude::*;
use val3_analysis::system::{Content, Disk, Kind, System};

/// The disk, read on several threads.
#[derive(Debug)]
pub(crate) struct ParallelDisk<'t> {
    /// The threads that read.
    pub(crate) threads: &'t ThreadPool,
}

impl System for ParallelDisk<'_> {
    fn read(&self, path: &Utf8Path) -> io::Result<Vec<u8>> {
        Disk.read(path)
    }

    fn read_all(&self, paths: &[Utf8PathBuf]) -> Vec<Option<Content>> {
        let read = |path: &Utf8PathBuf| Content::of(Disk.read(path));
        self.threads.install(|| paths.par_iter().with_min_len(8).map(read).collect())
    }

    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        Disk.list(path)
    }

    fn kind(&self, path: &Utf8Path) -> Option<Kind> {
        Disk.kind(path)
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        Disk.identity(path)
    }
}
