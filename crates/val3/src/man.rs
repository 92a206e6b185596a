//! `val3 man`: manual pages for packages, one for each command.

use std::fs;
use std::io;

use camino::Utf8Path;
use clap::{Command, CommandFactory as _};
use clap_mangen::Man;
use val3_files::{Unwritable, replace};

use crate::args::{Args, ManArgs};
use crate::output::to_stderr;
use crate::user_error::UserError;

/// Runs the command.
///
/// # Errors
/// The folder or a page cannot be written.
pub(crate) fn run(args: &ManArgs) -> Result<(), UserError> {
    let folder = args.folder.as_path();
    fs::create_dir_all(folder).map_err(|error| unwritable(folder, &error.into()))?;
    let mut command = Args::command().disable_help_subcommand(true);
    command.build();
    let count = write(folder, &command).map_err(|reason| unwritable(folder, &reason))?;
    to_stderr(|out| writeln!(out, "wrote {count} manual pages to {folder}"));
    Ok(())
}

fn unwritable(folder: &Utf8Path, reason: &Unwritable) -> UserError {
    UserError::new(format!("cannot write manual pages to `{folder}`: {reason}"))
        .with_help("name a folder that you may write to")
}

/// Writes the pages for a command and its subcommands. Returns the number of pages.
fn write(folder: &Utf8Path, command: &Command) -> Result<usize, Unwritable> {
    let name = command.get_display_name().unwrap_or_else(|| command.get_name());
    let text = page(command.clone())?;
    replace(&folder.join(format!("{name}.1")), &text)?;
    let inner = command.get_subcommands().filter(|inner| !inner.is_hide_set());
    inner.map(|inner| write(folder, inner)).try_fold(1, |count, written| Ok(count + written?))
}

fn page(command: Command) -> io::Result<Vec<u8>> {
    let mut text = Vec::new();
    Man::new(command).source(concat!("val3 ", env!("CARGO_PKG_VERSION"))).manual("VAL 3").render(&mut text)?;
    Ok(text)
}
