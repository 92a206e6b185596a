//! The `val3` command as it is used: arguments in, output and exit code out.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a fault of a test may stop it")]

mod check;
mod explain;
mod fixes;
mod formats;
mod statistics;
mod support;
mod usage;
mod watch;
