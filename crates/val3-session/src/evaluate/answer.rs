//! Evaluation output: values, printed lines, or a fault.

use std::fmt::{self, Display};
use std::ops::Range;

use val3_check::diagnostic::Diagnostic;
use val3_lang::runtime_errors;
use val3_lang::values::printed;
use val3_lines::{ColumnCounting, ColumnUnit, LineIndex};
use val3_machine::event::{Event, EventKind};
use val3_machine::missing_instruction;
use val3_syntax::{TextSize, TextSlice};

use super::page_text::PageText;
use super::sources::offset_in_code;

/// One item of the output.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum EvaluationOutput {
    /// An expression's value, or a line printed by a statement.
    Line(String),
    /// The code cannot be evaluated.
    Fault(CodeFault),
    /// The evaluation ended with this run-time error.
    RunTime(u16),
}

/// Reason why code cannot be evaluated, with its location in the code.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CodeFault {
    pub(super) message: String,
    /// Line from 0, characters before the fault, characters of the fault.
    place: Option<(usize, usize, usize)>,
}

impl From<String> for CodeFault {
    fn from(message: String) -> Self {
        Self { message, place: None }
    }
}

impl CodeFault {
    /// Converts a finding in the program that executes `code`, where the evaluated code follows `before` bytes.
    pub(super) fn found(finding: &Diagnostic, code: &str, before: usize) -> Self {
        let offset = |at: TextSize| offset_in_code(code, at.into()).saturating_sub(before);
        let range = offset(finding.place.range.start())..offset(finding.place.range.end());
        Self::at(finding.message.clone(), code.part(before..), range)
    }

    /// Fault at a byte range of the code.
    pub(crate) fn at(message: String, text: &str, range: Range<usize>) -> Self {
        Self { message, place: place(text, range.start, range.end) }
    }

    /// Message without its location.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// The faulty line of `text`, with marks below the fault.
    pub fn excerpt(&self, text: &str) -> Option<String> {
        let (line, before, marked) = self.place?;
        let line = text.lines().nth(line).unwrap_or_default();
        Some(format!("  {line}\n  {}{}", " ".repeat(before), "^".repeat(marked.max(1))))
    }
}

/// Line, number of characters before the range, and number of characters in the range. Only the first line of the range
/// counts.
fn place(text: &str, from: usize, to: usize) -> Option<(usize, usize, usize)> {
    const CHARACTERS: ColumnCounting = ColumnCounting { unit: ColumnUnit::Utf32, count_mark: true };
    let lines = LineIndex::new(text);
    let line = lines.line(from);
    let end = lines.line_range(line)?.end.max(from);
    let column = |offset| lines.line_column(offset, CHARACTERS).column as usize;
    Some((line, column(from), column(to.clamp(from, end)) - column(from)))
}

impl EvaluationOutput {
    /// Output that an event produces, after the lines on user pages that it completes.
    pub(crate) fn all_of(event: &Event, is_string: bool, page: &mut PageText) -> Vec<Self> {
        let mut lines = page.lines_of(event);
        let output = Self::of(event, is_string);
        if output.is_some() {
            lines.extend(page.take());
        }
        lines.into_iter().map(Self::Line).chain(output).collect()
    }

    /// Output that an event produces itself. The value of a string expression is in quotes.
    fn of(event: &Event, is_string: bool) -> Option<Self> {
        match &event.kind {
            EventKind::Print { text } if is_string => Some(Self::Line(printed::string(text))),
            EventKind::Print { text } => Some(Self::Line(text.clone())),
            EventKind::Log { text, .. } => Some(Self::Line(format!("log: {text}"))),
            EventKind::Popup { text } => Some(Self::Line(format!("pop-up: {text}"))),
            EventKind::Error { code, .. } => Some(Self::RunTime(*code)),
            EventKind::Lacking { instruction, .. } => Some(Self::Fault(missing_instruction(instruction).into())),
            _ => None,
        }
    }

    /// Whether it is neither a fault nor a run-time error.
    pub fn is_sound(&self) -> bool {
        matches!(self, Self::Line(_))
    }

    /// Fault of the code, if there is one.
    pub fn fault(&self) -> Option<&CodeFault> {
        match self {
            Self::Fault(fault) => Some(fault),
            _ => None,
        }
    }
}

impl Display for EvaluationOutput {
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
    use super::{CodeFault, place};

    #[test]
    fn the_position_of_a_fault_is_marked() {
        assert_eq!(excerpt("sA+1", 0, 2), "  sA+1\n  ^^");
        assert_eq!(excerpt("2+", 2, 2), "  2+\n    ^");
        assert_eq!(excerpt("\"é\"+nX", 5, 7), "  \"é\"+nX\n      ^^", "characters count, not bytes");
        assert_eq!(excerpt("nA=1\nnB=x\nnC=1", 8, 20), "  nB=x\n     ^", "to the end of its line");
    }

    fn excerpt(text: &str, from: usize, to: usize) -> String {
        let fault = CodeFault { message: String::new(), place: place(text, from, to) };
        fault.excerpt(text).unwrap_or_default()
    }
}
