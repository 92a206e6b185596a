//! The inputs: everything that is read from the disk.

#![allow(missing_docs, reason = "the builders and setters that salsa generates cannot be documented")]

use std::sync::Arc;

use camino::Utf8PathBuf;
use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_config::ConfigFile;
use val3_syntax::encoding::{Encoding, Mismatch};

use crate::cell::CellConfig;
use crate::paths::Roots;

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
        /// The encoding of its text.
        encoding: Encoding,
        /// How its bytes contradict the encoding that it declares.
        mismatch: Option<Mismatch>,
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
    /// The folders of `Disk://` and other roots of paths.
    #[returns(ref)]
    pub roots: Roots,
    /// The cell around it.
    #[returns(copy)]
    pub cell: Option<Cell>,
    /// Names of what lies in its folder, sorted.
    #[returns(ref)]
    pub beside: Vec<SmolStr>,
    /// The HTML files and the files of bindings of its user pages, sorted.
    #[returns(ref)]
    pub pages: Vec<File>,
    /// References of the project file that lead outside, as written. Their files are not read.
    #[returns(ref)]
    pub outside: Vec<SmolStr>,
    /// The nearest `val3.toml` above it.
    #[returns(copy)]
    pub configuration: Option<Configuration>,
    /// A folder `tests` of its cell leads to it.
    #[returns(copy)]
    pub is_below_tests: bool,
}

/// A `val3.toml`.
#[salsa::input(debug)]
pub struct Configuration {
    /// Its content.
    #[returns(ref)]
    pub file: ConfigFile,
}

/// A controller folder: `usr` with its `configs` and `app`.
#[salsa::input(debug)]
pub struct Cell {
    /// The content of its configuration files.
    #[returns(ref)]
    pub config: CellConfig,
}

/// Every file and project that was found.
#[salsa::input(singleton, debug)]
pub struct Sources {
    /// Files by their path key.
    #[returns(ref)]
    pub files: FxHashMap<String, File>,
    /// Programs and data in the folder of a project that no project lists, by their path key.
    #[returns(ref)]
    pub unlisted: FxHashMap<String, File>,
    /// Projects by the path key of their `.pjx`.
    #[returns(ref)]
    pub projects: FxHashMap<String, Project>,
}
