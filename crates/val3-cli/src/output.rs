//! Where text goes: the standard output, with or without colours, and files.

use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, Write};

use camino::Utf8Path;
use codespan_reporting::term::termcolor::{BufferedStandardStream, ColorChoice, NoColor, WriteColor};

use crate::args::Color;
use crate::user_error::UserError;

/// Writes to the standard output. A reader that went away is no error: it has read what it wanted.
pub(crate) fn to_stdout(
    color: Color,
    write: impl FnOnce(&mut dyn WriteColor) -> io::Result<()>,
) -> Result<(), UserError> {
    let mut out = BufferedStandardStream::stdout(color_choice(color));
    match write(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(UserError::new(format!("cannot write to the standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Writes to the standard error output; if that is not possible, there is nobody to tell.
pub(crate) fn to_stderr(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) {
    let _ = write(&mut io::stderr().lock());
}

/// Writes a file, without colours. An existing file is replaced.
pub(crate) fn to_file(
    path: &Utf8Path,
    write: impl FnOnce(&mut dyn WriteColor) -> io::Result<()>,
) -> Result<(), UserError> {
    let written = File::create(path).and_then(|file| {
        let mut out = NoColor::new(BufWriter::new(file));
        write(&mut out)?;
        out.flush()
    });
    written.map_err(|error| {
        UserError::new(format!("cannot write `{path}`: {error}"))
            .with_help("name a file in an existing folder that you may write to")
    })
}

fn color_choice(color: Color) -> ColorChoice {
    let wanted = match color {
        Color::Always => true,
        Color::Never => false,
        Color::Auto => io::stdout().is_terminal() && environment_allows_colors(),
    };
    if wanted { ColorChoice::Always } else { ColorChoice::Never }
}

/// Colours are unwanted where NO_COLOR has a value, and unreadable on a terminal that says it is dumb.
fn environment_allows_colors() -> bool {
    let no_color = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    let dumb = std::env::var_os("TERM").is_some_and(|value| value == "dumb");
    !no_color && !dumb
}
