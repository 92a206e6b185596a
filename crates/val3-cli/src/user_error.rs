//! Errors that stop a command: wrong usage, or a file that cannot be read or written.

use std::fmt::{self, Display};

/// Exit code of wrong usage, and of a file that cannot be read or written.
pub(crate) const EXIT_USAGE: u8 = 2;

/// An error for the person at the terminal; it ends the command with exit code 2.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct UserError {
    /// The problem and its place.
    message: String,
    /// The remedy; may be empty.
    help: String,
}

impl UserError {
    /// An error that needs no remedy.
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), help: String::new() }
    }

    /// Adds the remedy.
    pub(crate) fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = help.into();
        self
    }
}

impl Display for UserError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "error: {}", self.message)?;
        if !self.help.is_empty() {
            write!(f, "\n  help: {}", self.help)?;
        }
        Ok(())
    }
}

impl std::error::Error for UserError {}
