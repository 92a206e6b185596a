//! A writer that keeps control characters of checked files away from the terminal.

use std::io::{self, Write};

use codespan_reporting::diagnostic::{LabelStyle, Severity};
use codespan_reporting::term::termcolor::WriteColor;
use codespan_reporting::term::{GeneralWriteResult, WriteStyle};

/// Passes text on with `?` for every control character but tab and line feed; colours pass by their own way.
pub(crate) struct Printable<'a> {
    out: &'a mut dyn WriteColor,
    /// The word of a level is being written.
    in_level: bool,
}

impl<'a> Printable<'a> {
    /// A writer before `out`.
    pub(crate) fn new(out: &'a mut dyn WriteColor) -> Self {
        Self { out, in_level: false }
    }
}

impl Write for Printable<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // codespan knows the levels of compilers; ours has no note, it says info.
        let is_note = std::mem::take(&mut self.in_level) && bytes == b"note";
        let text: &[u8] = if is_note { b"info" } else { bytes };
        for part in text.split_inclusive(is_control) {
            match part.split_last() {
                Some((last, before)) if is_control(last) => {
                    self.out.write_all(before)?;
                    self.out.write_all(b"?")?;
                }
                _ => self.out.write_all(part)?,
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

fn is_control(byte: &u8) -> bool {
    byte.is_ascii_control() && !matches!(byte, b'\n' | b'\t')
}

impl WriteStyle for Printable<'_> {
    fn set_header(&mut self, severity: Severity) -> GeneralWriteResult {
        self.in_level = true;
        self.out.set_header(severity)
    }

    fn set_header_message(&mut self) -> GeneralWriteResult {
        self.out.set_header_message()
    }

    fn set_line_number(&mut self) -> GeneralWriteResult {
        self.out.set_line_number()
    }

    fn set_note_bullet(&mut self) -> GeneralWriteResult {
        self.out.set_note_bullet()
    }

    fn set_source_border(&mut self) -> GeneralWriteResult {
        self.out.set_source_border()
    }

    fn set_label(&mut self, severity: Severity, style: LabelStyle) -> GeneralWriteResult {
        self.out.set_label(severity, style)
    }

    fn reset(&mut self) -> GeneralWriteResult {
        WriteColor::reset(self.out)
    }
}

#[cfg(test)]
mod tests {
    use codespan_reporting::term::termcolor::NoColor;

    use super::*;

    #[test]
    fn control_characters_do_not_reach_the_terminal() {
        let mut out = NoColor::new(Vec::new());
        Printable::new(&mut out).write_all("\u{1b}[2Jé\t\r\n".as_bytes()).unwrap();
        assert_eq!(String::from_utf8(out.into_inner()).unwrap(), "?[2Jé\t?\n");
    }
}
