//! Shared by the tests in `tests/`: the example cells as files in memory, and findings.

#![allow(clippy::expect_used, clippy::panic, reason = "a missing or broken example is a fault of the test")]

pub mod cell;
mod finding;
pub mod fixing;
pub mod running;

pub use finding::Finding;

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
