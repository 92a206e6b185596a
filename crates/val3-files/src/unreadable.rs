//! Reasons why a file cannot be read.

use std::fmt;
use std::fs::FileType;
use std::io;

/// Reason why a file cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Unreadable {
    /// The file does not exist.
    Missing,
    /// The path is a folder.
    Folder,
    /// The path is a device.
    Device,
    /// The path is a pipe.
    Pipe,
    /// The path is a socket.
    Socket,
    /// The file exceeds its class limit.
    TooLarge {
        /// File size in bytes; `None` if it grew while it was read.
        bytes: Option<u64>,
        /// Limit of the class in bytes.
        limit: u64,
    },
    /// The user has no permission to read the file.
    Denied,
    /// The file is not UTF-8.
    NotUtf8,
    /// A name in the folder is not UTF-8. The wrong bytes are replaced by U+FFFD.
    NameNotUtf8(String),
    /// Any other error of the operating system.
    System(String),
}

impl Unreadable {
    /// Whether the file does not exist.
    pub fn is_missing(&self) -> bool {
        *self == Self::Missing
    }

    /// Reason why an entry of this type cannot be read as a file; `None` for a regular file.
    pub(crate) fn of_type(found: FileType) -> Option<Self> {
        if found.is_file() {
            return None;
        }
        if found.is_dir() {
            return Some(Self::Folder);
        }
        Some(Self::of_special(found))
    }

    #[cfg(unix)]
    fn of_special(found: FileType) -> Self {
        use std::os::unix::fs::FileTypeExt as _;
        match () {
            () if found.is_fifo() => Self::Pipe,
            () if found.is_socket() => Self::Socket,
            () => Self::Device,
        }
    }

    #[cfg(not(unix))]
    fn of_special(_: FileType) -> Self {
        Self::Device
    }
}

impl From<io::Error> for Unreadable {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            // A path below a regular file does not exist.
            io::ErrorKind::NotFound | io::ErrorKind::NotADirectory => Self::Missing,
            io::ErrorKind::PermissionDenied => Self::Denied,
            io::ErrorKind::IsADirectory => Self::Folder,
            _ => Self::System(error.to_string()),
        }
    }
}

impl fmt::Display for Unreadable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let limited = |limit: &u64| format!("at most {limit} bytes are read; --max-file-size raises the limit");
        match self {
            Self::Missing => f.write_str("it does not exist"),
            Self::Folder => f.write_str("it is a folder"),
            Self::Device => f.write_str("it is a device"),
            Self::Pipe => f.write_str("it is a pipe"),
            Self::Socket => f.write_str("it is a socket"),
            Self::TooLarge { bytes: Some(bytes), limit } => write!(f, "it has {bytes} bytes, and {}", limited(limit)),
            Self::TooLarge { bytes: None, limit } => write!(f, "it grows while it is read, and {}", limited(limit)),
            Self::Denied => f.write_str("permission denied"),
            Self::NotUtf8 => f.write_str("its text is not UTF-8"),
            Self::NameNotUtf8(name) => write!(f, "the name {name:?} in it is not UTF-8"),
            Self::System(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for Unreadable {}
