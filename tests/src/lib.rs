//! Shared by the tests in `tests/`: the example cells as files in memory, and findings.

#![allow(clippy::expect_used, clippy::panic, reason = "a missing or broken example is a fault of the test")]

pub mod cell;
pub mod fixing;
pub mod running;

use val3_check::testing::{CheckedFinding, check_files};

/// Every finding in a cell.
pub fn check(cell: &cell::Cell) -> Vec<Finding> {
    check_files(cell).into_iter().map(Finding::from).collect()
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

impl From<CheckedFinding> for Finding {
    fn from(checked: CheckedFinding) -> Self {
        let CheckedFinding { file, line, message, .. } = checked;
        Self { code: checked.code.to_owned(), file, line, message }
    }
}

impl Finding {
    /// Whether `other` has the same message for the same file, possibly on another line.
    pub fn is_like(&self, other: &Finding) -> bool {
        (&self.code, &self.file, &self.message) == (&other.code, &other.file, &other.message)
    }
}
