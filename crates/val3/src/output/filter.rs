//! Writer through which all text passes before its destination. Colours bypass it.

use std::io::{self, Write};

use codespan_reporting::term::termcolor::{ColorSpec, HyperlinkSpec, WriteColor};

use super::commands::CommandSearch;
use super::content::{Controls, Destination, OutputContent};
use crate::printable::{is_unprintable, push_picture};

/// Changes text as its [`OutputContent`] requires.
pub(super) struct Filter<'a> {
    out: &'a mut dyn WriteColor,
    controls: Controls,
    search: Option<CommandSearch>,
    /// First bytes of a character that the next write completes.
    partial: Vec<u8>,
    /// Whether the last character was a carriage return. Before a line feed, it belongs to the line end.
    after_return: bool,
    changed: String,
}

impl<'a> Filter<'a> {
    /// Runs `write` with a writer that filters text for `out`.
    pub(super) fn before(
        out: &'a mut dyn WriteColor,
        content: OutputContent,
        to: Destination,
        write: impl FnOnce(&mut dyn WriteColor) -> io::Result<()>,
    ) -> io::Result<()> {
        let controls = content.controls(to);
        let breaks_commands = content.breaks_commands(to);
        if controls == Controls::Kept && !breaks_commands {
            return write(out);
        }
        let search = breaks_commands.then(CommandSearch::default);
        let mut filter =
            Self { out, controls, search, partial: Vec::new(), after_return: false, changed: String::new() };
        write(&mut filter)?;
        filter.finish()
    }

    /// Writes incomplete characters at the end of the text.
    fn finish(&mut self) -> io::Result<()> {
        if self.after_return {
            self.after_return = false;
            self.push_control('\r');
        }
        if !self.partial.is_empty() {
            self.partial.clear();
            self.push(char::REPLACEMENT_CHARACTER);
        }
        self.pass()
    }

    /// Writes the filtered text.
    fn pass(&mut self) -> io::Result<()> {
        let written = self.out.write_all(self.changed.as_bytes());
        self.changed.clear();
        written
    }

    fn add(&mut self, text: &str) {
        text.chars().for_each(|character| self.add_character(character));
    }

    fn add_character(&mut self, character: char) {
        if std::mem::take(&mut self.after_return) {
            if character == '\n' { self.push('\r') } else { self.push_control('\r') }
        }
        match character {
            '\r' => self.after_return = true,
            control if is_unprintable(control) => self.push_control(control),
            other => self.push(other),
        }
    }

    fn push_control(&mut self, character: char) {
        match self.controls {
            Controls::Kept => self.push(character),
            Controls::Escaped => self.changed.push_str(&format!("\\u{:04x}", u32::from(character))),
            Controls::Pictured => {
                let mut picture = String::new();
                push_picture(character, &mut picture);
                picture.chars().for_each(|character| self.push(character));
            }
        }
    }

    fn push(&mut self, character: char) {
        let is_command = self.search.as_mut().is_some_and(|search| search.completes(character));
        match (is_command, self.controls) {
            (true, Controls::Escaped) => self.changed.push_str(&format!("\\u{:04x}", u32::from(character))),
            (true, _) => self.changed.extend(['\\', character]),
            (false, _) => self.changed.push(character),
        }
    }
}

impl Write for Filter<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut rest = std::mem::take(&mut self.partial);
        rest.extend_from_slice(bytes);
        let mut chunks = rest.utf8_chunks().peekable();
        while let Some(chunk) = chunks.next() {
            self.add(chunk.valid());
            match chunk.invalid() {
                [] => {}
                last if chunks.peek().is_none() && is_beginning(last) => self.partial = last.to_vec(),
                _ => self.add_character(char::REPLACEMENT_CHARACTER),
            }
        }
        self.pass()?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// Whether further bytes can complete a character.
fn is_beginning(bytes: &[u8]) -> bool {
    std::str::from_utf8(bytes).is_err_and(|error| error.error_len().is_none())
}

impl WriteColor for Filter<'_> {
    fn supports_color(&self) -> bool {
        self.out.supports_color()
    }

    fn supports_hyperlinks(&self) -> bool {
        self.out.supports_hyperlinks()
    }

    fn set_color(&mut self, spec: &ColorSpec) -> io::Result<()> {
        self.finish()?;
        self.out.set_color(spec)
    }

    fn set_hyperlink(&mut self, link: &HyperlinkSpec<'_>) -> io::Result<()> {
        self.finish()?;
        self.out.set_hyperlink(link)
    }

    fn reset(&mut self) -> io::Result<()> {
        self.finish()?;
        self.out.reset()
    }

    fn is_synchronous(&self) -> bool {
        self.out.is_synchronous()
    }
}

#[cfg(test)]
mod tests {
    use codespan_reporting::term::termcolor::{Ansi, Color, NoColor};

    use super::*;

    const TERMINAL: Destination = Destination { is_terminal: true, reads_commands: false };
    const SERVICE: Destination = Destination { is_terminal: false, reads_commands: true };
    const PIPE: Destination = Destination { is_terminal: false, reads_commands: false };

    fn written(content: OutputContent, to: Destination, parts: &[&[u8]]) -> String {
        let mut out = NoColor::new(Vec::new());
        Filter::before(&mut out, content, to, |out| parts.iter().try_for_each(|part| out.write_all(part))).unwrap();
        String::from_utf8(out.into_inner()).unwrap()
    }

    #[test]
    fn words_never_have_control_characters() {
        for to in [TERMINAL, SERVICE, PIPE] {
            let text = "\u{1b}]0;x\u{7}\u{9b}é\t\r\nb\rc\r".as_bytes();
            assert_eq!(written(OutputContent::Words, to, &[text]), "␛]0;x␇<9B>é\t\r\nb␍c␍");
        }
    }

    #[test]
    fn data_are_exact_unless_a_terminal_shows_them() {
        let text = "\u{1b}[2J\u{9b}\ra\r\n".as_bytes();
        for content in [OutputContent::Data, OutputContent::File] {
            assert_eq!(written(content, PIPE, &[text]).as_bytes(), text);
            assert_eq!(written(content, TERMINAL, &[text]), "␛[2J<9B>␍a\r\n");
        }
        assert_eq!(written(OutputContent::Data, SERVICE, &[text]).as_bytes(), text);
    }

    #[test]
    fn commands_of_a_service_are_broken_unless_they_are_the_output() {
        let text = b"a\n ::error::b ##[c]\n";
        for content in [OutputContent::Words, OutputContent::Data] {
            assert_eq!(written(content, SERVICE, &[text]), "a\n :\\:error::b ##\\[c]\n");
            assert_eq!(written(content, PIPE, &[text]).as_bytes(), text);
        }
        for content in [OutputContent::Commands, OutputContent::File] {
            assert_eq!(written(content, SERVICE, &[text]).as_bytes(), text);
        }
    }

    #[test]
    fn json_has_the_same_meaning() {
        let value = serde_json::json!({ "text": "\u{9b}31m\u{7f}\u{202e}\u{1b} ##[error] [é]", "list": [["::a"]] });
        for to in [TERMINAL, SERVICE, PIPE] {
            let json = written(OutputContent::Json, to, &[value.to_string().as_bytes()]);
            assert!(!json.contains(|character: char| is_unprintable(character)), "{json}");
            assert_eq!(json.contains("##["), to != SERVICE, "{json}");
            assert_eq!(serde_json::from_str::<serde_json::Value>(&json).unwrap(), value);
        }
    }

    #[test]
    fn characters_may_be_written_in_parts() {
        assert_eq!(written(OutputContent::Words, PIPE, &[b"\xc2", b"\x9b\xe4\xb8", b"\xad\r", b"\n"]), "<9B>中\r\n");
        assert_eq!(written(OutputContent::Words, PIPE, &[b"\xc3A\xff", b"\xc3"]), "\u{fffd}A\u{fffd}\u{fffd}");
        assert_eq!(written(OutputContent::Data, SERVICE, &[b":", b":x"]), ":\\:x");
    }

    #[test]
    fn colours_remain() {
        let mut out = Ansi::new(Vec::new());
        Filter::before(&mut out, OutputContent::Words, TERMINAL, |out| {
            out.set_color(ColorSpec::new().set_fg(Some(Color::Red)))?;
            write!(out, "\u{1b}[2J")?;
            out.reset()
        })
        .unwrap();
        assert_eq!(String::from_utf8(out.into_inner()).unwrap(), "\u{1b}[0m\u{1b}[31m␛[2J\u{1b}[0m");
    }
}
