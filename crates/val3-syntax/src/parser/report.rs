//! How the grammar reports faults: one a statement, one for the end of the file.

use rowan::TextRange;

use super::Parser;
use crate::error::{Expected, SyntaxError, SyntaxErrorKind};
use crate::kind::SyntaxKind::EOF;

impl Parser<'_> {
    /// Reports `kind` at the current token, or after the last one at the end of a line.
    pub(crate) fn error(&mut self, kind: SyntaxErrorKind) {
        let after = self.pos != self.statement && self.at_line_end();
        let range = if after { self.range_after() } else { self.range(self.pos) };
        self.error_at(kind, range, None);
    }

    pub(crate) fn expected(&mut self, expected: Expected) {
        let found = if self.at_line_end() { String::new() } else { self.text().to_owned() };
        self.error(SyntaxErrorKind::Expected { expected, found });
    }

    /// Reports a fault of the statement; only the first one of a statement is kept. Where the file breaks off, the
    /// element that is not closed has the message.
    pub(crate) fn error_at(&mut self, kind: SyntaxErrorKind, range: TextRange, related: Option<TextRange>) {
        if !self.failed && !self.at(EOF) {
            self.structure_error(kind, range, related);
        }
        self.failed = true;
    }

    /// Reports a fault of the structure around statements.
    pub(crate) fn structure_error(&mut self, kind: SyntaxErrorKind, range: TextRange, related: Option<TextRange>) {
        self.errors.push(SyntaxError { kind, range, related });
    }

    /// The statement already has its message.
    pub(crate) fn failed(&self) -> bool {
        self.failed
    }

    /// The text ends too early, and it has been said.
    pub(crate) fn is_end_reported(&self) -> bool {
        self.is_end_reported
    }

    /// The message just given is also the one for the end of the text.
    pub(crate) fn mark_end_reported(&mut self) {
        self.is_end_reported = true;
    }
}
