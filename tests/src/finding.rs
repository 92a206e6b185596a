//! Properties of a finding that tests compare.

/// A finding of a check.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// Rule code.
    pub code: String,
    /// Path relative to the controller's folder.
    pub file: String,
    /// First line, from 1.
    pub line: usize,
    /// Message.
    pub message: String,
}

impl Finding {
    /// Whether `other` has the same message for the same file, possibly on another line.
    pub fn is_like(&self, other: &Finding) -> bool {
        (&self.code, &self.file, &self.message) == (&other.code, &other.file, &other.message)
    }
}
