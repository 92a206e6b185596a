//! Errors in a cell file that its schema cannot detect.

use std::fmt;

/// An error in a `cell.toml`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CellError {
    /// Key with the error, for example `object[2].in`.
    pub key: String,
    /// One sentence that describes the error.
    pub message: String,
    /// Suggested correction; may be empty.
    pub help: String,
}

impl CellError {
    pub(crate) fn new(key: impl Into<String>, message: impl Into<String>, help: impl Into<String>) -> Self {
        Self { key: key.into(), message: message.into(), help: help.into() }
    }
}

impl fmt::Display for CellError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.key, self.message)
    }
}

impl std::error::Error for CellError {}
