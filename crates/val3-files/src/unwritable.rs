//! Reasons why a file cannot be written.

use std::fmt;
use std::io;

use camino::Utf8PathBuf;

/// Reason why a file cannot be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Unwritable {
    /// The path is no file, but a folder, device, pipe or socket.
    NotRegular,
    /// The user has no permission to write the file or its folder.
    Denied,
    /// The file is read-only.
    ReadOnly,
    /// Another process of the tools is writing the file.
    Busy,
    /// The content has changed since it was read.
    Changed,
    /// A write was interrupted, and this file contains the old content.
    Interrupted(Utf8PathBuf),
    /// The folder does not exist.
    NoFolder,
    /// Any other error of the operating system.
    System(String),
}

impl From<io::Error> for Unwritable {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::PermissionDenied => Self::Denied,
            io::ErrorKind::NotFound => Self::NoFolder,
            io::ErrorKind::IsADirectory => Self::NotRegular,
            _ => Self::System(error.to_string()),
        }
    }
}

impl fmt::Display for Unwritable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotRegular => f.write_str("it exists and is not a file"),
            Self::Denied => f.write_str("permission denied"),
            Self::ReadOnly => f.write_str("it is read-only"),
            Self::Busy => f.write_str("another run of val3 is writing it"),
            Self::Changed => f.write_str("another program has changed it in the meantime"),
            Self::Interrupted(backup) => {
                write!(f, "a write was interrupted; `{backup}` has the old content: restore it, or delete that file")
            }
            Self::NoFolder => f.write_str("there is no such folder"),
            Self::System(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for Unwritable {}
