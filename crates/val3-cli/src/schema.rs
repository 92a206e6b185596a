//! `val3 schema`: the JSON schema of `val3.toml`, for editors.

use crate::color::Color;
use crate::output::to_stdout;
use crate::user_error::UserError;

/// Runs the command.
pub(crate) fn run() -> Result<(), UserError> {
    to_stdout(Color::Never, |out| write!(out, "{}", val3_config::json_schema()))
}
