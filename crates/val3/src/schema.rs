//! `val3 schema`: JSON schemas for editors.

use crate::args::SchemaArgs;
use crate::color::Color;
use crate::dap;
use crate::output::{OutputContent, to_stdout_as};
use crate::user_error::UserError;

/// Runs the command.
pub(crate) fn run(args: &SchemaArgs) -> Result<(), UserError> {
    let schema = if args.debugger { dap::schema::json_schemas() } else { val3_config::json_schema() };
    to_stdout_as(OutputContent::Json, Color::Never, |out| write!(out, "{schema}"))
}
