//! `val3 arm show`: prints an arm file.

use val3_session::ArmFile;

use crate::args::ArmShowArgs;
use crate::color::Color;
use crate::output::to_stdout;
use crate::user_error::UserError;

/// Runs the command.
pub(super) fn run(args: &ArmShowArgs, color: Color) -> Result<(), UserError> {
    let file = ArmFile::named(&args.name)?;
    to_stdout(color, |out| write!(out, "{}", file.text))
}
