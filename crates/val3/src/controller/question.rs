//! Questions before a push, and before the first connection to a server with TLS.

use std::io::{BufRead as _, IsTerminal as _};

use crate::output::to_stderr;
use crate::printable::one_line;
use crate::user_error::UserError;

/// Whether the user can answer a question.
pub(crate) fn can_ask() -> bool {
    std::io::stdin().is_terminal()
}

/// Whether the user confirms the question with `y` or `yes`.
///
/// # Errors
/// The answer cannot be read.
pub(crate) fn is_confirmed(question: &str) -> Result<bool, UserError> {
    to_stderr(|out| write!(out, "{} [y/N] ", one_line(question)));
    let mut answer = String::new();
    let read = std::io::stdin().lock().read_line(&mut answer);
    read.map_err(|error| UserError::new(format!("cannot read the answer: {error}")))?;
    Ok(matches!(answer.trim().to_ascii_lowercase().as_str(), "y" | "yes"))
}
