//! Error reporting of the grammar: one error for each statement, and one for a truncated file.

use rowan::TextRange;

use super::Parser;
use crate::error::{Expected, SyntaxError, SyntaxErrorKind};
use crate::kind::SyntaxKind::EOF;

impl Parser<'_> {
    /// Reports `kind` at the current token; at the end of a line, after the last token.
    pub(crate) fn error(&mut self, kind: SyntaxErrorKind) {
        let after = self.pos != self.statement && self.at_line_end();
        let range = if after { self.range_after() } else { self.range(self.pos) };
        self.error_at(kind, range, None);
    }

    pub(crate) fn expected(&mut self, expected: Expected) {
        let found = if self.at_line_end() { String::new() } else { self.text().to_owned() };
        self.error(SyntaxErrorKind::Expected { expected, found });
    }

    /// Reports an error in the statement. Only the first error of a statement is kept. If the file is truncated, only
    /// the unclosed element is reported.
    pub(crate) fn error_at(&mut self, kind: SyntaxErrorKind, range: TextRange, related: Option<TextRange>) {
        if !self.failed && !self.at(EOF) {
            self.structure_error(kind, range, related);
        }
        self.failed = true;
    }

    /// Reports an error in the structure around statements.
    pub(crate) fn structure_error(&mut self, kind: SyntaxErrorKind, range: TextRange, related: Option<TextRange>) {
        self.errors.push(SyntaxError { kind, range, related });
    }

    /// Whether an error was already reported for the statement.
    pub(crate) fn failed(&self) -> bool {
        self.failed
    }

    /// Whether a truncated text was already reported.
    pub(crate) fn is_end_reported(&self) -> bool {
        self.is_end_reported
    }

    /// Records that the last error also reports the end of the text.
    pub(crate) fn mark_end_reported(&mut self) {
        self.is_end_reported = true;
    }
}
