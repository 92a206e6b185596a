//! The parser from outside: its trees, its messages, its recovery, and the laws it keeps.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "tests")]

mod faults;
mod files;
mod hostile;
mod laws;
mod recovery;
mod show;
mod statements;
