//! A finding, as far as a suite judges it.

/// A finding of a check.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// The code of the rule.
    pub code: String,
    /// Path relative to the controller's folder.
    pub file: String,
    /// The line it begins on, from 1.
    pub line: usize,
    /// The message.
    pub message: String,
}

impl Finding {
    /// Whether `other` says the same about the same file, perhaps on another line.
    pub fn is_like(&self, other: &Finding) -> bool {
        (&self.code, &self.file, &self.message) == (&other.code, &other.file, &other.message)
    }
}
