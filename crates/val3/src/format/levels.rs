//! Writer for codespan that replaces its level names.

use std::io::{self, Write};

use codespan_reporting::diagnostic::{LabelStyle, Severity};
use codespan_reporting::term::termcolor::WriteColor;
use codespan_reporting::term::{GeneralWriteResult, WriteStyle};

/// Approximate buffer size in bytes.
const PENDING: usize = 4096;

/// Buffers the text, because codespan writes single characters, and replaces level names.
pub(crate) struct Levels<'a> {
    out: &'a mut dyn WriteColor,
    /// Buffered text in the current colour.
    pending: Vec<u8>,
    /// Whether codespan is writing a level name.
    in_level: bool,
}

impl<'a> Levels<'a> {
    /// Runs `write` with a writer for `out`.
    pub(crate) fn before(
        out: &'a mut dyn WriteColor,
        write: impl FnOnce(&mut Self) -> io::Result<()>,
    ) -> io::Result<()> {
        let mut levels = Self { out, pending: Vec::with_capacity(2 * PENDING), in_level: false };
        write(&mut levels)?;
        levels.flush_buffer().map(drop)
    }

    /// Writes the buffer and returns the inner writer.
    fn flush_buffer(&mut self) -> io::Result<&mut dyn WriteColor> {
        self.out.write_all(&self.pending)?;
        self.pending.clear();
        Ok(self.out)
    }
}

impl Write for Levels<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // Codespan has the levels of compilers; its `note` is the level `info`.
        let is_note = std::mem::take(&mut self.in_level) && bytes == b"note";
        let text: &[u8] = if is_note { b"info" } else { bytes };
        self.pending.extend_from_slice(text);
        if self.pending.len() > PENDING {
            self.flush_buffer()?;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.flush_buffer()?.flush()
    }
}

impl WriteStyle for Levels<'_> {
    fn set_header(&mut self, severity: Severity) -> GeneralWriteResult {
        self.in_level = true;
        self.flush_buffer()?.set_header(severity)
    }

    fn set_header_message(&mut self) -> GeneralWriteResult {
        self.flush_buffer()?.set_header_message()
    }

    fn set_line_number(&mut self) -> GeneralWriteResult {
        self.flush_buffer()?.set_line_number()
    }

    fn set_note_bullet(&mut self) -> GeneralWriteResult {
        self.flush_buffer()?.set_note_bullet()
    }

    fn set_source_border(&mut self) -> GeneralWriteResult {
        self.flush_buffer()?.set_source_border()
    }

    fn set_label(&mut self, severity: Severity, style: LabelStyle) -> GeneralWriteResult {
        self.flush_buffer()?.set_label(severity, style)
    }

    fn reset(&mut self) -> GeneralWriteResult {
        WriteColor::reset(self.flush_buffer()?)
    }
}
