//! What a backup of a controller contains beside its applications: the messages of its logs, and a description of the
//! controller itself.
//!
//! The files come from a [`BackupFiles`]: a folder, an archive or a controller. This crate opens nothing itself.

mod date_time;
mod files;
pub mod info;
pub mod log;

pub use date_time::DateTime;
pub use files::{BackupFile, BackupFiles, MemoryFiles};
