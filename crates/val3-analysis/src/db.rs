//! The salsa database and its inputs.
//!
//! Everything that is read from the disk is an input, which the loader sets (`load`). Queries never access a file
//! system.

mod inputs;
mod trees;

use std::sync::Arc;

use camino::Utf8Path;
use val3_config::Config;
use val3_lang::types::Arm;
use val3_syntax::{TextRange, apply_edits};

pub use inputs::{CellFolder, Configuration, File, FileStatus, MeshFile, Project, Sources};
pub use trees::Trees;

/// A range in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct FileRange {
    /// The file.
    pub file: File,
    /// Range in bytes of the decoded UTF-8 text.
    pub range: TextRange,
}

/// Replacement of a range in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FileEdit {
    /// The file.
    pub file: File,
    /// Replaced range; empty for an insertion.
    pub range: TextRange,
    /// New text, encoded like the file: escaped if the code is escaped.
    pub text: String,
}

impl FileEdit {
    /// Returns `text` after these edits of one file, which are sorted, inside the text, and do not overlap.
    pub fn apply_all<'e>(text: &str, edits: impl IntoIterator<Item = &'e Self>) -> String {
        apply_edits(text, edits.into_iter().map(|edit| (edit.range, edit.text.as_str())))
    }
}

/// Database interface that queries use.
#[salsa::db]
pub trait Db: salsa::Database {
    /// Returns the cache of syntax trees.
    fn trees(&self) -> &Trees;
}

/// The database. Clones share all data; a clone serves as a snapshot for another thread.
#[salsa::db]
#[derive(Clone, Default)]
pub struct Database {
    storage: salsa::Storage<Self>,
    trees: Arc<Trees>,
}

#[salsa::db]
impl salsa::Database for Database {}

#[salsa::db]
impl Db for Database {
    fn trees(&self) -> &Trees {
        &self.trees
    }
}

impl Database {
    /// Creates a database that reports each executed query to `observer`, for tests of incrementality.
    pub fn observed(observer: impl Fn(salsa::Event) + Send + Sync + 'static) -> Self {
        Self { storage: salsa::Storage::new(Some(Box::new(observer))), trees: Arc::default() }
    }
}

impl std::fmt::Debug for Database {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Database")
    }
}

impl Project {
    /// Returns the folder of `Disk://`; `None` if it is unknown.
    pub fn disk(self, db: &dyn Db) -> Option<&Utf8Path> {
        self.roots(db).disk.as_deref()
    }

    /// Returns the content of the nearest `val3.toml`.
    pub fn config(self, db: &dyn Db) -> Option<&Config> {
        self.configuration(db).map(|configuration| &configuration.file(db).config)
    }

    /// Returns the kind of arm in the cell's configuration, if any.
    pub fn cell_arm(self, db: &dyn Db) -> Option<Arm> {
        self.cell(db).and_then(|cell| cell.config(db).arm)
    }
}
