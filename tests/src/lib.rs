//! What the suites in `tests/` share: the example cells as files in memory, and findings.

#![allow(clippy::panic, reason = "a missing example is a fault of the test that asks for it")]

pub mod cell;
mod finding;

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
