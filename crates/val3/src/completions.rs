//! `val3 completions`: a script that completes commands and options in a shell.

use clap::CommandFactory as _;

use crate::args::{Args, CompletionsArgs};
use crate::color::Color;
use crate::output::{OutputContent, to_stdout_as};
use crate::user_error::UserError;

/// Runs the command.
pub(crate) fn run(args: &CompletionsArgs) -> Result<(), UserError> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Args::command(), "val3", &mut script);
    to_stdout_as(OutputContent::File, Color::Never, |out| out.write_all(&script))
}
