//! `install`: the command `val3` for this user.

use crate::project;

/// Builds and installs the binary where cargo installs binaries.
///
/// # Errors
/// When the build fails.
pub fn run() -> anyhow::Result<()> {
    project::succeed(&mut project::cargo(&["install", "--path", "crates/val3-cli", "--locked"]))
}
