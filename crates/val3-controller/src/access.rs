//! Access to the files of a controller, independent of the transport.

use std::fmt::{self, Display};

use crate::path::{ControllerPath, NameFault};

/// Files of a controller. Each call is one operation on the controller; nothing is repeated silently.
pub trait ControllerFiles {
    /// Host and port, or the folder, for messages.
    fn place(&self) -> &str;

    /// Returns the entries of a folder, sorted by name.
    ///
    /// # Errors
    /// If the folder cannot be listed, or a name is not allowed.
    fn list(&mut self, folder: &ControllerPath) -> Result<Vec<ListedEntry>, AccessError>;

    /// Returns the content of a file with at most `limit` bytes.
    ///
    /// # Errors
    /// If the file cannot be read or is longer.
    fn read(&mut self, file: &ControllerPath, limit: u64) -> Result<Vec<u8>, AccessError>;

    /// Writes a file, and replaces its content if it exists.
    ///
    /// # Errors
    /// If the file cannot be written. It may then have a part of the content.
    fn write(&mut self, file: &ControllerPath, bytes: &[u8]) -> Result<(), AccessError>;

    /// Renames a file. A controller may reject it if the new name exists.
    ///
    /// # Errors
    /// If the file cannot be renamed.
    fn rename(&mut self, from: &ControllerPath, to: &ControllerPath) -> Result<(), AccessError>;

    /// Removes a file.
    ///
    /// # Errors
    /// If the file cannot be removed.
    fn remove(&mut self, file: &ControllerPath) -> Result<(), AccessError>;

    /// Creates a folder.
    ///
    /// # Errors
    /// If the folder cannot be created.
    fn make_folder(&mut self, folder: &ControllerPath) -> Result<(), AccessError>;

    /// Removes an empty folder.
    ///
    /// # Errors
    /// If the folder cannot be removed.
    fn remove_folder(&mut self, folder: &ControllerPath) -> Result<(), AccessError>;

    /// Establishes the connection once more after an error.
    ///
    /// # Errors
    /// If the controller cannot be reached.
    fn reconnect(&mut self) -> Result<(), AccessError>;
}

/// Entry of a folder on a controller.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct ListedEntry {
    /// Path of the entry.
    pub path: ControllerPath,
    /// Whether the entry is a folder.
    pub is_folder: bool,
}

/// Failed operation on a controller.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AccessError {
    /// The operation, for example "read `usr/configs/arm.cfx`".
    pub step: String,
    /// Host and port, or the folder.
    pub place: String,
    /// Cause.
    pub reason: AccessFault,
}

/// Cause of a failed operation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum AccessFault {
    /// The controller has rejected the command.
    Rejected {
        /// Code of the reply, for example 550.
        code: u32,
        /// Text of the reply.
        text: String,
    },
    /// The connection failed or was lost.
    Connection(String),
    /// The controller did not respond in time.
    Timeout,
    /// An entry of a folder is neither a file nor a folder.
    Special(String),
    /// A line of a listing has no known form.
    Listing(String),
    /// A name that is not used as a file name.
    Name(NameFault),
    /// A file or listing with more bytes than the limit.
    TooLarge(u64),
    /// Error of the file system.
    FileSystem(String),
}

impl AccessError {
    /// Whether the controller has rejected the command permanently.
    pub(crate) fn is_rejection(&self) -> bool {
        matches!(self.reason, AccessFault::Rejected { code: 500..=599, .. })
    }

    /// Whether only this file or folder cannot be read, so that others can.
    pub(crate) fn is_of_one_entry(&self) -> bool {
        let is_denied = matches!(self.reason, AccessFault::Rejected { code: 450 | 550..=553, .. });
        is_denied || matches!(self.reason, AccessFault::FileSystem(_) | AccessFault::Special(_))
    }
}

impl Display for AccessError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot {} at {}: {}", self.step, self.place, self.reason)
    }
}

impl Display for AccessFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rejected { code, text } => write!(f, "{code} {text}"),
            Self::Connection(reason) => write!(f, "the connection failed: {reason}"),
            Self::Timeout => f.write_str("the controller does not respond in time"),
            Self::Special(name) => write!(f, "`{name}` is a link or a device, which is not followed"),
            Self::Listing(line) => write!(f, "the line {line:?} of the listing has no known form"),
            Self::Name(fault) => write!(f, "{fault}"),
            Self::TooLarge(limit) => write!(f, "it has more than {limit} bytes"),
            Self::FileSystem(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for AccessError {}
