//! The salsa database and its inputs.
//!
//! Everything read from the disk is an input, set by the loader (`load`); queries never touch a file system.

mod inputs;
mod trees;

use std::sync::Arc;

use camino::Utf8Path;
use val3_config::Config;
use val3_lang::types::Arm;
use val3_syntax::TextRange;

pub use inputs::{Cell, Configuration, File, FileStatus, Project, Sources};
pub use trees::Trees;

/// A range of the text of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct FileRange {
    /// The file.
    pub file: File,
    /// UTF-8 bytes of the decoded text.
    pub range: TextRange,
}

/// The interface of a database that queries use.
#[salsa::db]
pub trait Db: salsa::Database {
    /// The trees of files.
    fn trees(&self) -> &Trees;
}

/// The database. Clones share all data; a clone is a snapshot for another thread.
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
    /// A database that reports each query it runs to `observer`; for tests of incrementality.
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
    /// The folder of `Disk://`; `None` where it is unknown.
    pub fn disk(self, db: &dyn Db) -> Option<&Utf8Path> {
        self.roots(db).disk.as_deref()
    }

    /// The content of the `val3.toml` above it.
    pub fn config(self, db: &dyn Db) -> Option<&Config> {
        self.configuration(db).map(|configuration| &configuration.file(db).config)
    }

    /// The arm of the cell, if its configuration gives it.
    pub fn cell_arm(self, db: &dyn Db) -> Option<Arm> {
        self.cell(db).and_then(|cell| cell.config(db).arm)
    }
}
