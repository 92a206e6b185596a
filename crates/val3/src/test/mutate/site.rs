//! Mistake: one small change in a program or data file.

use std::ops::Range;

use val3_syntax::decode_entities;
use val3_syntax::xml::escaped;

/// Mistake at a location of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Site {
    /// Data path of a value; `None` in a program.
    pub(super) path: Option<String>,
    /// Line in the file, from 1.
    pub(super) line: u32,
    /// Replaced text, without XML escapes.
    pub(super) found: String,
    /// New text; empty for a removed statement.
    pub(super) replacement: String,
    /// Byte range of the replaced text.
    pub(super) range: Range<usize>,
    pub(super) escapes: Escapes,
}

/// XML escapes at the location of a mistake.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Escapes {
    /// No escapes, in a CDATA section.
    None,
    /// Escapes in text.
    Text,
    /// Escapes in attributes.
    Attribute,
}

impl Site {
    /// Text of the file with the mistake.
    pub(super) fn applied(&self, text: &str) -> String {
        let written = match self.escapes {
            Escapes::None => self.replacement.clone(),
            Escapes::Text => self.replacement.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;"),
            Escapes::Attribute => escaped(&self.replacement).replace('\'', "&apos;"),
        };
        let before = text.get(..self.range.start).unwrap_or_default();
        let after = text.get(self.range.end..).unwrap_or_default();
        format!("{before}{written}{after}")
    }

    /// Line with the mistake in the text of the file, without surrounding blanks and, in code, without XML escapes.
    pub(super) fn source(&self, text: &str) -> String {
        let line = text.lines().nth((self.line as usize).saturating_sub(1)).unwrap_or_default();
        let line = if self.escapes == Escapes::Text { decode_entities(line) } else { line.into() };
        line.trim().to_owned()
    }

    /// Description of the change: `` `<=` becomes `<` ``, `` pPick.trsf.z: `120` becomes `130` ``.
    pub(super) fn change(&self) -> String {
        let path = self.path.as_ref().map(|path| format!("{path}: ")).unwrap_or_default();
        match self.replacement.as_str() {
            "" => format!("{path}`{}` is removed", self.found),
            replacement => format!("{path}`{}` becomes `{replacement}`", self.found),
        }
    }
}

/// Line number of a byte, from 1.
pub(super) fn line_at(text: &str, byte: usize) -> u32 {
    let before = text.bytes().take(byte).filter(|byte| *byte == b'\n').count();
    u32::try_from(before).unwrap_or(u32::MAX).saturating_add(1)
}
