//! Errors that stop a command: wrong usage, or a file that cannot be read or written.

use std::fmt::{self, Display};

use crate::printable::one_line;

/// Exit code of wrong usage, and of a file that cannot be read or written.
pub(crate) const EXIT_USAGE: u8 = 2;

/// An error message for the user, with visible control characters. It ends the command with exit code 2.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct UserError {
    /// Problem and location, in one line.
    message: String,
    /// Further lines; may be empty.
    details: String,
    /// Remedy; may be empty.
    help: String,
}

impl UserError {
    /// Creates an error without a remedy.
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { message: one_line(&message.into()).into_owned(), details: String::new(), help: String::new() }
    }

    /// Joins errors: the first one is followed by the lines of the others. `None` without errors.
    pub(crate) fn joined(errors: Vec<Self>) -> Option<Self> {
        let [first, others @ ..] = errors.as_slice() else { return None };
        if others.is_empty() {
            return errors.into_iter().next();
        }
        let text = first.to_string();
        let rest = text.split_once('\n').map(|(_, rest)| rest.to_owned());
        let details: Vec<String> = rest.into_iter().chain(others.iter().map(Self::to_string)).collect();
        Some(Self { message: first.message.clone(), details: details.join("\n"), help: String::new() })
    }

    /// Problem and location, in one line.
    pub(crate) fn message(&self) -> &str {
        &self.message
    }

    /// Text without the prefix `error: `, for a report with several errors.
    pub(crate) fn lines(&self) -> String {
        let text = self.to_string();
        text.strip_prefix("error: ").unwrap_or(&text).to_owned()
    }

    /// Sets the lines after the message.
    pub(crate) fn with_details(mut self, details: impl Into<String>) -> Self {
        self.details = details.into();
        self
    }

    /// Sets the remedy.
    pub(crate) fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = one_line(&help.into()).into_owned();
        self
    }
}

impl Display for UserError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "error: {}", self.message)?;
        if !self.details.is_empty() {
            write!(f, "\n{}", self.details)?;
        }
        if !self.help.is_empty() {
            write!(f, "\n  help: {}", self.help)?;
        }
        Ok(())
    }
}

impl std::error::Error for UserError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joined_errors_keep_their_remedies() {
        let errors = ["a", "b", "c"].map(UserError::new);
        let [a, b, c] = errors;
        assert_eq!(UserError::joined(vec![]), None);
        assert_eq!(UserError::joined(vec![a.clone()]), Some(a.clone()));
        let joined = UserError::joined(vec![a.with_help("free space"), b.with_details("line"), c]).unwrap();
        assert_eq!(joined.to_string(), "error: a\n  help: free space\nerror: b\nline\nerror: c");
    }
}
