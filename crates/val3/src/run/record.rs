//! Event record of a run: one JSON object per line (`--events`).

use std::io::{self, BufWriter, ErrorKind, Write};

use camino::{Utf8Path, Utf8PathBuf};
use codespan_reporting::term::termcolor::NoColor;
use serde::Serialize;
use val3_machine::event::Event;

use super::recorded_options::RecordedOptions;
use crate::output::file_kind::OutputFileKind;
use crate::output::{Destination, OutputContent, file, filtered};
use crate::user_error::UserError;

/// Kind of the line with the options of the run.
pub(super) const BEGIN: &str = "begin";

/// First line of a record.
#[derive(Serialize)]
struct BeginLine<'o> {
    t: f64,
    kind: &'static str,
    options: &'o RecordedOptions,
}

/// Output of the event record.
pub(crate) struct Record {
    out: Option<Box<dyn Write>>,
    path: Utf8PathBuf,
    to: Destination,
    is_read: bool,
}

impl Record {
    /// Opens a record in a file, on the standard output (`-`), or without output.
    pub(crate) fn open(path: Option<&Utf8Path>) -> Result<Self, UserError> {
        let path = path.unwrap_or(Utf8Path::new("")).to_owned();
        let out: Option<Box<dyn Write>> = match path.as_str() {
            "" => None,
            "-" => Some(Box::new(BufWriter::new(io::stdout()))),
            _ => Some(Box::new(BufWriter::new(file::create_log(&path, OutputFileKind::Events, "events")?))),
        };
        let to = if path == "-" { Destination::stdout() } else { Destination::FILE };
        Ok(Self { out, path, to, is_read: true })
    }

    /// Whether the record uses the standard output, so that human-readable output goes elsewhere.
    pub(crate) fn takes_stdout(&self) -> bool {
        self.path == "-"
    }

    /// Writes the options of the run, as the first line.
    pub(super) fn begin(&mut self, options: &RecordedOptions) -> Result<(), UserError> {
        self.write_line(&BeginLine { t: 0.0, kind: BEGIN, options })
    }

    /// Writes an event.
    pub(crate) fn write(&mut self, event: &Event) -> Result<(), UserError> {
        self.write_line(event)
    }

    /// Writes a line. A closed pipe is no error.
    fn write_line(&mut self, line: &impl Serialize) -> Result<(), UserError> {
        let Some(out) = &mut self.out else { return Ok(()) };
        let written = filtered(OutputContent::Json, self.to, &mut NoColor::new(out), |out| {
            serde_json::to_writer(&mut *out, line)?;
            writeln!(out)
        });
        self.judge(written)
    }

    /// Whether the reader of the record has closed it.
    pub(crate) fn is_abandoned(&self) -> bool {
        !self.is_read
    }

    /// Flushes the buffer.
    pub(crate) fn flush(&mut self) -> Result<(), UserError> {
        let written = self.out.as_mut().map_or(Ok(()), |out| out.flush());
        self.judge(written)
    }

    fn judge(&mut self, written: io::Result<()>) -> Result<(), UserError> {
        match written {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => self.is_read = false,
            Err(error) => return Err(refused(&self.path, &error)),
            Ok(()) => {}
        }
        Ok(())
    }
}

fn refused(path: &Utf8Path, error: &io::Error) -> UserError {
    UserError::new(format!("cannot write the events to `{path}`: {error}"))
        .with_help("name a file in an existing folder that you may write to, or - for the standard output")
}
