//! Faults in texts to be assembled.

use std::fmt;

pub(super) type Result<T> = std::result::Result<T, AssemblyError>;

/// A fault in a text to be assembled.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AssemblyError {
    /// Line, from 1.
    pub line: u32,
    /// Character of the line, from 1.
    pub column: u32,
    /// Description of the fault.
    pub message: String,
}

impl fmt::Display for AssemblyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.line, self.column, self.message)
    }
}

impl std::error::Error for AssemblyError {}
