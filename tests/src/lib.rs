//! Shared by the tests in `tests/`: the example cells as files in memory, and findings.

#![allow(clippy::expect_used, clippy::panic, reason = "a missing or broken example is a fault of the test")]

pub mod cell;
mod finding;
pub mod fixing;
pub mod running;

pub use finding::Finding;

/// Codes of rules that need a complete project. An example is an excerpt, in the form of s7 regardless of the declared
/// version.
pub const OF_WHOLE_PROJECTS: [&str; 11] =
    ["V0113", "V0114", "V0115", "V0116", "V0117", "V0118", "V0119", "V0120", "V0341", "V0533", "V0534"];

/// Returns every finding in a cell.
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
