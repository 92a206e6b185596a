//! Shared by the tests in `tests/`: the example cells as files in memory, and findings.

#![allow(clippy::expect_used, clippy::panic, reason = "a missing or broken example is a fault of the test")]

pub mod cell;
pub mod fixing;
pub mod running;

/// Every finding in a cell.
pub fn check(cell: &cell::Cell) -> Vec<Finding> {
    let found = val3_check::testing::check_files(cell);
    let finding = |found: val3_check::testing::CheckedFinding| Finding {
        code: found.code.to_owned(),
        file: found.file,
        line: found.line,
        message: found.message,
    };
    found.into_iter().map(finding).collect()
}

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
