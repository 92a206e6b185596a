//! Comparison with the distances that two other libraries compute.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a failed test panics")]

mod pairs;
