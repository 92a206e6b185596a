//! Tests of the protocol layer.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail loudly")]

mod frames;
mod instances;
mod requests;
mod validation;
