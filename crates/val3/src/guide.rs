//! `val3 guide`: prints the page with the primer of VAL 3 and of the commands.

use crate::color::Color;
use crate::output::{OutputContent, to_stdout_as};
use crate::user_error::UserError;

/// The page, also a page of the book.
const PAGE: &str = include_str!("../../../docs/src/guide.md");

/// Runs the command. The page is printed as Markdown, so that it can be stored in a file.
pub(crate) fn run() -> Result<(), UserError> {
    to_stdout_as(OutputContent::Data, Color::Never, |out| write!(out, "{PAGE}"))
}
