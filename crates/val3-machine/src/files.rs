//! Media of the controller: paths, libraries and files, all inside of the mounted folders (6.5 to 6.7).
//!
//! This module raises no run-time errors: each failure is a [`FileFault`], whose number the instructions return.

mod fault;
mod library;
mod moving;
mod open_files;
mod overlay;
mod path;
mod reserved;
mod roots;
mod volume;

pub use fault::FileFault;
pub use library::{LibraryFile, LibraryFiles, LibraryPath, Steps, Uninterrupted, list, unpack};
pub use moving::{copy, delete, file_exists, rename};
pub use open_files::{OpenFiles, OpenMode};
pub use overlay::Overlay;
pub use path::ControllerPath;
pub use roots::{EntryKind, MountedPath, Roots};
