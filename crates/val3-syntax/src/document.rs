//! XML files whose structure must be intact: configuration files of a cell (`arm.cfx`, `sio.cfx`) and programs.

use std::fmt;

use crate::encoding::decode;
use crate::error::{SyntaxError, SyntaxErrorKind};
use crate::foreign::ForeignContent;

/// Reason why the content of a file is unknown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DocumentFault {
    /// The bytes are no controller text.
    Foreign(ForeignContent),
    /// The file ends inside an element, or its tags do not match.
    Broken {
        /// Line number, from 1.
        line: usize,
        /// Kind of the fault.
        kind: BrokenStructure,
    },
}

/// A fault that hides the structure of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum BrokenStructure {
    /// The element has no end tag, or a tag or comment continues to the end of the file.
    Unclosed,
    /// The end tag closes no element.
    EndTag {
        /// Name in the end tag.
        name: String,
    },
    /// A line of a merge conflict.
    ConflictMarker,
    /// No root element, or several.
    RootElement,
    /// A `<` that begins no tag, or a malformed tag.
    Tag,
}

/// Decodes a configuration file.
///
/// # Errors
/// If the bytes are no text, or the structure is broken.
pub fn text(bytes: Vec<u8>) -> Result<String, DocumentFault> {
    if let Some(foreign) = ForeignContent::of(&bytes) {
        return Err(DocumentFault::Foreign(foreign));
    }
    let text = decode(bytes).text;
    match fault(&text, crate::parse(&text).errors()) {
        Some(fault) => Err(fault),
        None => Ok(text),
    }
}

/// Returns the first syntax error that breaks the structure. A merge conflict takes precedence, because it causes the
/// other errors; so does a text without an element.
pub fn fault(text: &str, errors: &[SyntaxError]) -> Option<DocumentFault> {
    let faults = || errors.iter().filter_map(|error| Some((structure_fault(text, error)?, error.range.start())));
    let cause = |kind: &BrokenStructure| faults().find(|(found, _)| found == kind);
    let explanation = cause(&BrokenStructure::ConflictMarker).or_else(|| cause(&BrokenStructure::RootElement));
    let (kind, start) = explanation.or_else(|| faults().next())?;
    let before = text.get(..usize::from(start)).unwrap_or(text);
    Some(DocumentFault::Broken { line: 1 + memchr::memchr_iter(b'\n', before.as_bytes()).count(), kind })
}

/// Whether no tag ends after the error.
fn is_in_last_tag(text: &str, error: &SyntaxError) -> bool {
    text.get(usize::from(error.range.start())..).is_some_and(|rest| !rest.contains('>'))
}

fn structure_fault(text: &str, error: &SyntaxError) -> Option<BrokenStructure> {
    Some(match &error.kind {
        SyntaxErrorKind::UnclosedElement { .. } | SyntaxErrorKind::Unterminated(_) => BrokenStructure::Unclosed,
        SyntaxErrorKind::UnexpectedText if !text.contains('<') => BrokenStructure::RootElement,
        // The text ends within `<!--` or `/>`.
        SyntaxErrorKind::UnexpectedText | SyntaxErrorKind::Doctype if is_in_last_tag(text, error) => {
            BrokenStructure::Unclosed
        }
        SyntaxErrorKind::UnmatchedEndTag { name } => BrokenStructure::EndTag { name: name.clone() },
        SyntaxErrorKind::ConflictMarker => BrokenStructure::ConflictMarker,
        SyntaxErrorKind::RootElement => BrokenStructure::RootElement,
        SyntaxErrorKind::MalformedAttribute { .. } => BrokenStructure::Tag,
        _ => return None,
    })
}

impl fmt::Display for DocumentFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (line, kind) = match self {
            Self::Foreign(foreign) => return foreign.fmt(f),
            Self::Broken { line, kind } => (line, kind),
        };
        write!(f, "line {line}: ")?;
        match kind {
            BrokenStructure::Unclosed => f.write_str("an element is not closed; the file is cut off or damaged"),
            BrokenStructure::EndTag { name } => write!(f, "`</{name}>` closes no element; the file is damaged"),
            BrokenStructure::ConflictMarker => f.write_str("a merge conflict is not resolved"),
            BrokenStructure::RootElement => f.write_str("one XML element must enclose everything"),
            BrokenStructure::Tag => f.write_str("this is no XML tag"),
        }
    }
}

impl std::error::Error for DocumentFault {}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(content: &str) -> String {
        text(content.as_bytes().to_vec()).unwrap_err().to_string()
    }

    #[test]
    fn the_fault_says_what_the_file_is() {
        let unclosed = "an element is not closed; the file is cut off or damaged";
        assert_eq!(fault("<arm>\n<broken"), format!("line 2: {unclosed}"));
        assert_eq!(fault("<arm>\n<String name=\"arm\" val"), format!("line 2: {unclosed}"));
        assert_eq!(fault("<arm>\n<String name=\"a\" value=\"\"/>\n"), format!("line 1: {unclosed}"));
        assert_eq!(fault("<arm>\n<!-- x"), format!("line 2: {unclosed}"));
        assert_eq!(fault("<arm>\n</bio>\n</arm>"), "line 2: `</bio>` closes no element; the file is damaged");
        assert_eq!(
            fault("<arm>\n<<<<<<< HEAD\n<a>\n=======\n<b>\n>>>>>>> x\n</arm>"),
            "line 2: a merge conflict is not resolved"
        );
        assert_eq!(fault("no xml"), "line 1: one XML element must enclose everything");
        assert_eq!(fault("  "), "it is empty; copy it again");
    }

    #[test]
    fn files_of_controllers_are_read_and_any_part_of_one_is_not() {
        let file = "\u{feff}<?xml version=\"1.0\" encoding=\"utf-8\" ?>\n<arm>\n  <!-- note -->\n  \
                    <String name=\"arm\" value=\"tx2_60-S1\" />\n  <FloatArray name='x'><Float index=\"0\" \
                    value=\"-1\"/></FloatArray>\n</arm>\n";
        assert_eq!(text(file.as_bytes().to_vec()).as_deref(), Ok(file));
        let ends = file.char_indices().map(|(end, _)| end).filter(|end| *end < file.trim_end().len());
        for end in ends {
            let part = &file[..end];
            assert!(text(part.as_bytes().to_vec()).is_err(), "{part}");
        }
    }
}
