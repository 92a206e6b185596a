//! Comparisons of entire applications.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a fault of a test may stop it")]

mod arrays;
mod broken;
mod cells;
mod data;
mod dialects;
mod exclusions;
mod formats;
mod laws;
mod listed;
mod positions;
mod programs;
mod renames;
mod single_changes;
mod support;
