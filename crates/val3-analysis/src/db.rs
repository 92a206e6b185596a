//! The salsa database and its inputs.
//!
//! Everything read from the disk is an input, set by the loader (`load`); queries never touch a file system.

use std::sync::Arc;

use camino::Utf8PathBuf;
use rustc_hash::FxHashMap;
use val3_lang::types::Arm;
use val3_syntax::encoding::Encoding;

use crate::cell::CellConfig;

/// One file of the workspace.
#[salsa::input(debug)]
pub struct File {
    /// Where it lies, as spelt on the disk.
    #[returns(ref)]
    pub path: Utf8PathBuf,
    /// The text, decoded; empty where the file cannot be read.
    #[returns(ref)]
    pub text: Arc<str>,
    /// How it was read.
    #[returns(ref)]
    pub status: FileStatus,
}

/// How a file was read.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum FileStatus {
    /// It was read.
    Read {
        /// How its bytes stand for its text.
        encoding: Encoding,
        /// Its bytes are not in the encoding it declares.
        undeclared: bool,
    },
    /// It is there and cannot be read, for this reason.
    Unreadable(String),
}

/// One application, library or user type: a `.pjx` with the place it is read from.
#[salsa::input(debug)]
pub struct Project {
    /// The `.pjx`.
    #[returns(copy)]
    pub manifest: File,
    /// What `Disk://` stands for; `None` where nothing tells.
    #[returns(ref)]
    pub disk: Option<Utf8PathBuf>,
    /// The cell around it.
    #[returns(copy)]
    pub cell: Option<Cell>,
}

/// A controller folder: `usr` with its `configs` and `app`.
#[salsa::input(debug)]
pub struct Cell {
    /// What its configuration files say.
    #[returns(ref)]
    pub config: CellConfig,
}

/// Every file and project that was found.
#[salsa::input(singleton, debug)]
pub struct Sources {
    /// Files by their path key.
    #[returns(ref)]
    pub files: FxHashMap<String, File>,
    /// Projects by the path key of their `.pjx`.
    #[returns(ref)]
    pub projects: FxHashMap<String, Project>,
}

/// The key under which a path is found: files are looked up without regard to letter case.
pub fn path_key(path: &str) -> String {
    path.to_lowercase()
}

/// What queries need of a database.
#[salsa::db]
pub trait Db: salsa::Database {}

/// The database. Clones share all data; a clone is a snapshot for another thread.
#[salsa::db]
#[derive(Clone, Default)]
pub struct Database {
    storage: salsa::Storage<Self>,
}

#[salsa::db]
impl salsa::Database for Database {}

#[salsa::db]
impl Db for Database {}

impl Database {
    /// A database that tells `observer` each query it runs; for tests of incrementality.
    pub fn observed(observer: impl Fn(salsa::Event) + Send + Sync + 'static) -> Self {
        Self { storage: salsa::Storage::new(Some(Box::new(observer))) }
    }
}

impl std::fmt::Debug for Database {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Database")
    }
}

impl Project {
    /// The arm of the cell, if its configuration tells.
    pub fn cell_arm(self, db: &dyn Db) -> Option<Arm> {
        self.cell(db).and_then(|cell| cell.config(db).arm)
    }
}
