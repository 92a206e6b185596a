//! What the suites in `tests/` share: the example cells as files in memory, and findings.

#![allow(clippy::panic, reason = "a missing example is a fault of the test that asks for it")]

pub mod cell;
mod finding;

pub use finding::Finding;
