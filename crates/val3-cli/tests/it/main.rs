//! The `val3` command as it is used: arguments in, output and exit code out.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a fault of a test may stop it")]

mod baseline;
mod check;
mod configuration;
mod explain;
mod formats;
mod support;
mod usage;
