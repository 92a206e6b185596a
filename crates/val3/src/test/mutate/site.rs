//! A mistake: one small change of a program or of a data file.

use std::ops::Range;

use val3_syntax::decode_entities;
use val3_syntax::xml::escaped;

/// A mistake.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Site {
    /// Data path of a value; `None` in a program.
    pub(super) path: Option<String>,
    /// The line of the file, from 1.
    pub(super) line: u32,
    /// What is replaced, without the escapes of XML.
    pub(super) found: String,
    /// What stands there instead; empty for a statement that is removed.
    pub(super) replacement: String,
    /// Bytes that are replaced.
    pub(super) range: Range<usize>,
    pub(super) escapes: Escapes,
}

/// Escapes of XML where a mistake is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Escapes {
    /// None: a CDATA section.
    None,
    /// Those of text.
    Text,
    /// Those of an attribute.
    Attribute,
}

impl Site {
    /// The text of the file with the mistake.
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

    /// The line of the mistake in the text of its file, without the blanks around it and, in code, the escapes of XML.
    pub(super) fn source(&self, text: &str) -> String {
        let line = text.lines().nth((self.line as usize).saturating_sub(1)).unwrap_or_default();
        let line = if self.escapes == Escapes::Text { decode_entities(line) } else { line.into() };
        line.trim().to_owned()
    }

    /// The change in words: `` `<=` becomes `<` ``, `` pPick.trsf.z: `120` becomes `130` ``.
    pub(super) fn change(&self) -> String {
        let path = self.path.as_ref().map(|path| format!("{path}: ")).unwrap_or_default();
        match self.replacement.as_str() {
            "" => format!("{path}`{}` is removed", self.found),
            replacement => format!("{path}`{}` becomes `{replacement}`", self.found),
        }
    }
}

/// The line of a byte, from 1.
pub(super) fn line_at(text: &str, byte: usize) -> u32 {
    let before = text.bytes().take(byte).filter(|byte| *byte == b'\n').count();
    u32::try_from(before).unwrap_or(u32::MAX).saturating_add(1)
}
