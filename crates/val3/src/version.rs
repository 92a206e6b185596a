//! `val3 version` and the version of the command.

use crate::color::Color;
use crate::output::to_stdout;
use crate::user_error::UserError;

/// Version with commit and date, for example `0.1.0 (abcdef123 2026-11-26)`; without them for a build outside of a
/// repository.
pub(crate) const VERSION: &str = env!("VAL3_VERSION");

/// Runs the command.
pub(crate) fn run() -> Result<(), UserError> {
    to_stdout(Color::Never, |out| writeln!(out, "val3 {VERSION}"))
}
