//! What comes of a text, line by line.

use std::fmt::{self, Display};

use val3_check::diagnostic::Diagnostic;
use val3_lang::runtime_errors;
use val3_lang::values::printed;
use val3_machine::event::{Event, What};

use crate::application::lacking;

/// A line of what comes of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Answer {
    /// The value of an expression, or what a statement prints.
    Line(String),
    /// What is wrong with the text.
    Fault(Fault),
    /// The run-time error that it ends in.
    RunTime(u16),
}

/// What keeps a text from being evaluated.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fault {
    message: String,
    /// Where it is in the text: the line from 0, and the characters before and in it.
    place: Option<(usize, usize, usize)>,
}

impl From<String> for Fault {
    fn from(message: String) -> Self {
        Self { message, place: None }
    }
}

impl Fault {
    /// A finding in a file whose text has `text` behind `before` bytes.
    pub(super) fn found(finding: &Diagnostic, before: usize, text: &str) -> Self {
        let from = usize::from(finding.place.range.start()).saturating_sub(before);
        let to = usize::from(finding.place.range.end()).saturating_sub(before);
        Self { message: finding.message.clone(), place: place(text, from.min(text.len()), to) }
    }

    /// The line that it is in, with marks below its place.
    pub(super) fn excerpt(&self, text: &str) -> Option<String> {
        let (line, before, marked) = self.place?;
        let line = text.lines().nth(line).unwrap_or_default();
        Some(format!("  {line}\n  {}{}", " ".repeat(before), "^".repeat(marked.max(1))))
    }
}

/// The line, and the characters before and in a stretch of a text, as far as it is in this line.
fn place(text: &str, from: usize, to: usize) -> Option<(usize, usize, usize)> {
    let before = text.get(..from)?;
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let end = text.get(from..)?.find('\n').map_or(text.len(), |length| from + length);
    let count = |range| text.get(range).map(|part: &str| part.chars().count());
    Some((before.matches('\n').count(), count(start..from)?, count(from..to.clamp(from, end))?))
}

impl Answer {
    /// What an event tells who asked; of a string the value is shown in quotes.
    pub(super) fn of(event: &Event, is_string: bool) -> Option<Self> {
        match &event.what {
            What::Print { text } if is_string => Some(Self::Line(printed::string(text))),
            What::Print { text } => Some(Self::Line(text.clone())),
            What::Log { text, .. } => Some(Self::Line(format!("log: {text}"))),
            What::Popup { text } => Some(Self::Line(format!("pop-up: {text}"))),
            What::Error { code, .. } => Some(Self::RunTime(*code)),
            What::Lacking { instruction, .. } => Some(Self::Fault(lacking(instruction).into())),
            _ => None,
        }
    }

    /// The text was evaluated.
    pub(super) fn is_sound(&self) -> bool {
        matches!(self, Self::Line(_))
    }

    /// The fault of the text, if there is one.
    pub(super) fn fault(&self) -> Option<&Fault> {
        match self {
            Self::Fault(fault) => Some(fault),
            _ => None,
        }
    }
}

impl Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => f.write_str(line),
            Self::Fault(fault) => write!(f, "error: {}", fault.message),
            Self::RunTime(code) => {
                let short = runtime_errors::find(*code).map_or("unknown", |error| error.short);
                write!(f, "error {code}: {short}")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Fault, place};

    #[test]
    fn the_place_of_a_fault_is_marked() {
        let shown = |text: &str, from, to| {
            let fault = Fault { message: String::new(), place: place(text, from, to) };
            fault.excerpt(text).unwrap_or_default()
        };
        assert_eq!(shown("sA+1", 0, 2), "  sA+1\n  ^^");
        assert_eq!(shown("2+", 2, 2), "  2+\n    ^");
        assert_eq!(shown("\"é\"+nX", 5, 7), "  \"é\"+nX\n      ^^", "characters count, not bytes");
        assert_eq!(shown("nA=1\nnB=x\nnC=1", 8, 20), "  nB=x\n     ^", "to the end of its line");
    }
}
