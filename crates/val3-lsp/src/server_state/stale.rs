//! Stale files, to be read again before anything is computed.

use camino::Utf8Path;
use rustc_hash::FxHashSet;
use val3_analysis::paths::{normalise, path_key};

/// Stale files.
pub(super) enum Stale {
    /// Path keys of files, and of folders with all their contents.
    Paths(FxHashSet<String>),
    /// All files.
    Everything,
}

impl Stale {
    /// No file; only the settings have changed.
    pub(super) fn settings() -> Self {
        Self::Paths(FxHashSet::default())
    }

    /// Adds a file, or a folder with all its contents.
    pub(super) fn add(&mut self, path: &Utf8Path) {
        if let Self::Paths(paths) = self {
            paths.insert(path_key(normalise(path).as_str()));
        }
    }

    /// Whether the file with this path key is stale.
    pub(super) fn contains(&self, key: &str) -> bool {
        match self {
            Self::Paths(paths) => Utf8Path::new(key).ancestors().any(|path| paths.contains(path.as_str())),
            Self::Everything => true,
        }
    }
}
