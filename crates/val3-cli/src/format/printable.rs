//! A writer that keeps control characters of checked files away from the terminal.

use std::io::{self, Write};

use codespan_reporting::diagnostic::{LabelStyle, Severity};
use codespan_reporting::term::termcolor::WriteColor;
use codespan_reporting::term::{GeneralWriteResult, WriteStyle};

/// Approximate number of bytes that are buffered.
const PENDING: usize = 4096;

/// Replaces every control character except tab and line feed by `?`. Colours bypass the filter.
pub(crate) struct Printable<'a> {
    out: &'a mut dyn WriteColor,
    /// The last text in one colour. Codespan writes character by character.
    pending: Vec<u8>,
    /// Whether the word of a level is being written.
    in_level: bool,
}

impl<'a> Printable<'a> {
    /// Runs `write` with a writer that filters text for `out`.
    pub(crate) fn before(
        out: &'a mut dyn WriteColor,
        write: impl FnOnce(&mut Self) -> io::Result<()>,
    ) -> io::Result<()> {
        let mut printable = Self { out, pending: Vec::with_capacity(2 * PENDING), in_level: false };
        write(&mut printable)?;
        printable.flush_buffer().map(drop)
    }

    /// Writes the buffer out and returns the inner writer.
    fn flush_buffer(&mut self) -> io::Result<&mut dyn WriteColor> {
        self.out.write_all(&self.pending)?;
        self.pending.clear();
        Ok(self.out)
    }
}

impl Write for Printable<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // Codespan has the levels of compilers. Its level note is our level info.
        let is_note = std::mem::take(&mut self.in_level) && bytes == b"note";
        let text: &[u8] = if is_note { b"info" } else { bytes };
        self.pending.extend(text.iter().map(|byte| if is_control(*byte) { b'?' } else { *byte }));
        if self.pending.len() > PENDING {
            self.flush_buffer()?;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.flush_buffer()?.flush()
    }
}

fn is_control(byte: u8) -> bool {
    byte.is_ascii_control() && !matches!(byte, b'\n' | b'\t')
}

impl WriteStyle for Printable<'_> {
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

#[cfg(test)]
mod tests {
    use codespan_reporting::term::termcolor::NoColor;

    use super::*;

    #[test]
    fn control_characters_do_not_reach_the_terminal() {
        let mut out = NoColor::new(Vec::new());
        Printable::before(&mut out, |out| out.write_all("\u{1b}[2Jé\t\r\n".as_bytes())).unwrap();
        assert_eq!(String::from_utf8(out.into_inner()).unwrap(), "?[2Jé\t?\n");
    }
}
