//! `val3 schema`: JSON schemas for editors.

use val3_cell::CellFile;

use crate::args::SchemaArgs;
use crate::color::Color;
use crate::dap;
use crate::output::{OutputContent, to_stdout_as};
use crate::user_error::UserError;

/// Runs the command.
pub(crate) fn run(args: &SchemaArgs) -> Result<(), UserError> {
    let schema = match args {
        SchemaArgs { debugger: true, .. } => dap::schema::json_schemas(),
        SchemaArgs { cell: true, .. } => val3_config::json_schema_of::<CellFile>("cell.toml"),
        SchemaArgs { .. } => val3_config::json_schema(),
    };
    to_stdout_as(OutputContent::Json, Color::Never, |out| write!(out, "{schema}"))
}
