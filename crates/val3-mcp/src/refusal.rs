//! Reasons why a call cannot be executed.

use std::fmt;

/// Reason why a call cannot be executed, with the remedy: wrong arguments, a path outside of the roots, a limit.
///
/// An error in a VAL 3 program is no refusal: it is reported in an answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal(pub String);

impl Refusal {
    /// Creates a refusal.
    pub fn new(reason: impl Into<String>) -> Self {
        Self(reason.into())
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Refusal {}
