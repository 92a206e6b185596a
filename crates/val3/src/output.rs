//! Text output: the standard output, with or without colours, and files. All text passes through a filter, so that
//! untrusted names, messages and code cannot control a terminal ([`OutputContent`]).

mod commands;
mod content;
pub(crate) mod file;
pub(crate) mod file_kind;
mod filter;
mod redirection;

use std::fmt::Display;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use camino::Utf8Path;
use codespan_reporting::term::termcolor::{Buffer, BufferedStandardStream, ColorChoice, NoColor, WriteColor};
use val3_files::OutputFile;

use self::file_kind::{OutputFileKind, check_replaceable};
use crate::color::Color;
use crate::printable::one_line;
use crate::user_error::UserError;
pub(crate) use content::{Destination, OutputContent};
use filter::Filter;
pub(crate) use redirection::{commit, redirect};

/// Returns terminal output as text, with ANSI escape sequences if the debug client supports them.
pub(crate) fn text(has_colors: bool, write: &dyn Fn(&mut dyn WriteColor) -> io::Result<()>) -> String {
    let mut out = if has_colors { Buffer::ansi() } else { Buffer::no_color() };
    // Writing to a buffer cannot fail.
    let _ = filtered(OutputContent::Words, Destination::FILE, &mut out, write);
    String::from_utf8_lossy(out.as_slice()).into_owned()
}

/// Formats an argument in one line, as messages quote it.
pub(crate) fn shown_argument(argument: &str) -> String {
    let mut out = Buffer::no_color();
    // Writing to a buffer cannot fail.
    let _ = Filter::before(&mut out, OutputContent::Words, Destination::stderr(), |out| {
        write!(out, "{}", one_line(argument))
    });
    String::from_utf8_lossy(out.as_slice()).into_owned()
}

/// Writes to a destination, filtered as `content` requires.
pub(crate) fn filtered(
    content: OutputContent,
    to: Destination,
    out: &mut dyn WriteColor,
    write: impl FnOnce(&mut dyn WriteColor) -> io::Result<()>,
) -> io::Result<()> {
    Filter::before(out, content, to, write)
}

/// Writes human-readable text to the standard output. A closed pipe is no error, because its reader has received
/// enough.
pub(crate) fn to_stdout(
    color: Color,
    write: impl FnOnce(&mut dyn WriteColor) -> io::Result<()>,
) -> Result<(), UserError> {
    to_stdout_as(OutputContent::Words, color, write)
}

/// As [`to_stdout`], for another content kind.
pub(crate) fn to_stdout_as(
    content: OutputContent,
    color: Color,
    write: impl FnOnce(&mut dyn WriteColor) -> io::Result<()>,
) -> Result<(), UserError> {
    to_reader(content, color, write).map(|_| ())
}

/// As [`to_stdout_as`]. Returns whether the output is still read.
pub(crate) fn to_reader(
    content: OutputContent,
    color: Color,
    write: impl FnOnce(&mut dyn WriteColor) -> io::Result<()>,
) -> Result<bool, UserError> {
    if redirection::is_redirected() {
        return to_redirection(content, write).map(|()| true);
    }
    let mut out = BufferedStandardStream::stdout(color_choice(color, io::stdout().is_terminal()));
    match Filter::before(&mut out, content, Destination::stdout(), write).and_then(|()| out.flush()) {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(false),
        Err(error) => Err(UserError::new(format!("cannot write to the standard output: {error}"))),
    }
}

/// Writes to the file of `--output`.
fn to_redirection(
    content: OutputContent,
    write: impl FnOnce(&mut dyn WriteColor) -> io::Result<()>,
) -> Result<(), UserError> {
    // Buffered first: writing the text may access other outputs, which must not wait for the lock on this file.
    let mut text = Buffer::no_color();
    // Writing to a buffer cannot fail.
    let _ = Filter::before(&mut text, content, Destination::FILE, write);
    redirection::write(|file| file.write_all(text.as_slice())).unwrap_or(Ok(()))
}

/// Clears the screen if the standard output is a terminal.
pub(crate) fn clear_screen() {
    if io::stdout().is_terminal() {
        // Clears the screen and the scrollback, and moves the cursor to the first line.
        let _ = write!(io::stdout().lock(), "\u{1b}[2J\u{1b}[3J\u{1b}[H");
    }
}

/// Writes to the standard error output. Write errors are ignored, because they cannot be reported.
pub(crate) fn to_stderr(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) {
    to_stderr_in_color(Color::Never, |mut out| write(&mut out));
}

/// Whether `--verbose` is set.
static IS_VERBOSE: AtomicBool = AtomicBool::new(false);

/// Enables [`to_verbose`].
pub(crate) fn set_verbose() {
    IS_VERBOSE.store(true, Ordering::Relaxed);
}

/// Writes a note to the standard error output if `--verbose` is set.
pub(crate) fn to_verbose(note: impl FnOnce() -> String) {
    if IS_VERBOSE.load(Ordering::Relaxed) {
        to_stderr(|out| writeln!(out, "verbose: {}", one_line(&note())));
    }
}

/// Writes to the standard error output, with colours if they are enabled.
pub(crate) fn to_stderr_in_color(color: Color, write: impl FnOnce(&mut dyn WriteColor) -> io::Result<()>) {
    let mut out = BufferedStandardStream::stderr(color_choice(color, io::stderr().is_terminal()));
    let _ = Filter::before(&mut out, OutputContent::Words, Destination::stderr(), write).and_then(|()| out.flush());
}

/// Writes a file without colours. An existing file is replaced atomically if its content has the same kind.
pub(crate) fn to_file(
    path: &Utf8Path,
    kind: OutputFileKind,
    write: impl FnOnce(&mut dyn WriteColor) -> io::Result<()>,
) -> Result<(), UserError> {
    check_replaceable(path, kind, "output")?;
    let mut file = OutputFile::open(path).map_err(|reason| unwritable(path, &reason))?;
    let mut out = NoColor::new(BufWriter::new(&mut file));
    write(&mut out).and_then(|()| out.flush()).map_err(|error| unwritable(path, &error))?;
    drop(out);
    file.commit().map_err(|reason| unwritable(path, &reason))
}

fn unwritable(path: &Utf8Path, reason: &dyn Display) -> UserError {
    UserError::new(format!("cannot write `{path}`: {reason}"))
        .with_help("name a file in an existing folder that you may write to")
}

fn color_choice(color: Color, is_terminal: bool) -> ColorChoice {
    if color.is_wanted(is_terminal) { ColorChoice::Always } else { ColorChoice::Never }
}
