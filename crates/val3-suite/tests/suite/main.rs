//! Applications with their tests, each on a controller.
#![allow(
    clippy::disallowed_methods,
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test may fail loudly, and prepares files"
)]

mod assertions;
mod bench;
mod clearance;
mod counting;
mod expectations;
mod final_state;
mod motion;
mod stages;
mod tables;
