//! Salsa inputs: all data that the loader reads from the disk.

#![allow(missing_docs, reason = "the builders and setters that salsa generates cannot be documented")]

use std::sync::Arc;

use camino::Utf8PathBuf;
use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_cell::Mesh;
use val3_config::ConfigFile;
use val3_syntax::encoding::{Encoding, Mismatch};

use crate::cell::CellConfig;
use crate::paths::Roots;

/// A file of the workspace.
#[salsa::input(debug)]
pub struct File {
    /// Path as spelt on the disk.
    #[returns(ref)]
    pub path: Utf8PathBuf,
    /// Decoded text; empty if the file cannot be read.
    #[returns(ref)]
    pub text: Arc<str>,
    /// Result of reading the file.
    #[returns(ref)]
    pub status: FileStatus,
}

/// Result of reading a file.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum FileStatus {
    /// The file was read.
    Read {
        /// Encoding of the text.
        encoding: Encoding,
        /// Contradiction between the bytes and the declared encoding.
        mismatch: Option<Mismatch>,
    },
    /// The file exists but cannot be read, for this reason.
    Unreadable(String),
}

/// One application, library or user type: a `.pjx` and its surroundings.
#[salsa::input(debug)]
pub struct Project {
    /// Project file (`.pjx`).
    #[returns(copy)]
    pub manifest: File,
    /// Folders of `Disk://` and other path roots.
    #[returns(ref)]
    pub roots: Roots,
    /// Enclosing cell.
    #[returns(copy)]
    pub cell: Option<CellFolder>,
    /// Sorted names of the entries in the project's folder.
    #[returns(ref)]
    pub beside: Vec<SmolStr>,
    /// HTML files and binding files of the user pages, sorted.
    #[returns(ref)]
    pub pages: Vec<File>,
    /// `cell.toml` with the things around the arm of an application.
    #[returns(copy)]
    pub surroundings: Option<File>,
    /// Meshes that `cell.toml` names, followed by the meshes that `[run] shapes` of the `val3.toml` names.
    #[returns(ref)]
    pub meshes: Vec<MeshFile>,
    /// References in the project file to paths outside of the cell, as written. Their files are not read.
    #[returns(ref)]
    pub outside: Vec<SmolStr>,
    /// Nearest `val3.toml` in the project's folder or above.
    #[returns(copy)]
    pub configuration: Option<Configuration>,
    /// Whether a folder `tests` of the cell contains the project.
    #[returns(copy)]
    pub is_below_tests: bool,
}

/// A mesh of a thing or of a link.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshFile {
    /// Full path.
    pub path: Utf8PathBuf,
    /// Triangles, or the reason why the file cannot be used.
    pub mesh: Result<Arc<Mesh>, String>,
}

/// A `val3.toml`.
#[salsa::input(debug)]
pub struct Configuration {
    /// Content of the file.
    #[returns(ref)]
    pub file: ConfigFile,
}

/// A controller folder: `usr` with its `configs` and `app`.
#[salsa::input(debug)]
pub struct CellFolder {
    /// Content of the configuration files.
    #[returns(ref)]
    pub config: CellConfig,
}

/// All files and projects that the loader has found.
#[salsa::input(singleton, debug)]
pub struct Sources {
    /// Files by path key.
    #[returns(ref)]
    pub files: FxHashMap<String, File>,
    /// Unlisted programs and data in project folders, by path key.
    #[returns(ref)]
    pub unlisted: FxHashMap<String, File>,
    /// Projects by the path key of the `.pjx`.
    #[returns(ref)]
    pub projects: FxHashMap<String, Project>,
}
