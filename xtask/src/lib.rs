//! Tasks of the project, one per module. The benchmarks use [`workspace`] for their input.
//!
//! The crate depends on no crate of the toolchain, so that it can be built while such a crate cannot.
#![allow(clippy::disallowed_methods, reason = "a build tool reads the clock and the environment")]

pub mod build;
pub mod dap;
pub mod debug_info;
pub mod dist;
pub mod format;
pub mod install;
pub mod metrics;
pub mod node;
pub mod notices;
pub mod packaging_tools;
pub mod project;
pub mod requirements;
pub mod setup;
pub mod test;
pub mod tidy;
pub mod vsix;
pub mod workspace;
