//! Contents of a controller backup, apart from applications: log messages, and a description of the controller.
//!
//! The files come from a [`BackupFiles`]: a folder, an archive or a controller. This crate opens nothing itself.

mod date_time;
mod files;
pub mod info;
pub mod log;

pub use date_time::DateTime;
pub use files::{BackupFile, BackupFiles, MemoryFiles, UnreadFile};
