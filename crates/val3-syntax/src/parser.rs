//! The machinery of the parser: tokens in, events out, errors collected. The grammar uses it.

mod input;
mod marker;
mod reading;
mod report;
mod sink;

pub(crate) use input::Input;
pub(crate) use marker::{Completed, Marker};
pub(crate) use sink::build_tree;

use rowan::TextRange;

use crate::error::{SyntaxError, SyntaxErrorKind};
use crate::kind::SyntaxKind::{self, *};
use crate::lexer::Indent;

/// Operands, blocks and elements together nest at most this deep, and operators in a row make the tree at most this
/// high: far more than the controller takes, and little enough for every recursive walk over the tree.
pub(crate) const NESTING_LIMIT: u32 = 200;
/// Blocks and elements leave at least this much of it to the expressions inside of them.
const LEFT_TO_EXPRESSIONS: u32 = 100;

/// The events of the grammar, in order; the tree is built from them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Event {
    /// A node starts. `parent` is the distance to a later `Start` of a node that encloses this one, 0 for none.
    Start { kind: SyntaxKind, parent: u32 },
    /// The innermost node ends.
    Finish,
    /// The next token belongs to the innermost node.
    Token,
    /// A node that was given up.
    Abandoned,
}

/// How a keyword finds the block that it ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Matching {
    /// The nearest open block of its kind.
    Plain,
    /// Of those, the one that it lines up with.
    Guided,
    /// The innermost block or none.
    Strict,
}

/// The parser: a cursor over the tokens that are no trivia.
pub(crate) struct Parser<'i> {
    input: &'i Input<'i>,
    pos: usize,
    /// The first token of the statement being read, which may be the first of its line.
    statement: usize,
    /// An error was reported for this statement; the rest of its line is skipped in silence.
    failed: bool,
    /// A fault already reports that the text ends too early, so the open elements report nothing.
    is_end_reported: bool,
    /// Levels of nesting around the current token.
    depth: u32,
    /// Height of the tallest node completed so far in the innermost node.
    height: u32,
    pub(crate) matching: Matching,
    events: Vec<Event>,
    errors: Vec<SyntaxError>,
}

impl<'i> Parser<'i> {
    /// A parser for a text inside of `depth` elements.
    pub(crate) fn new(input: &'i Input<'i>, depth: u32) -> Self {
        Self {
            input,
            pos: 0,
            statement: 0,
            failed: false,
            is_end_reported: input.is_cut_off(),
            depth,
            height: 0,
            matching: Matching::Plain,
            events: Vec::with_capacity(input.len() * 2),
            errors: Vec::new(),
        }
    }

    pub(crate) fn finish(self) -> (Vec<Event>, Vec<SyntaxError>) {
        (self.events, self.errors)
    }

    // ---- looking ----

    /// The current token.
    pub(crate) fn current(&self) -> SyntaxKind {
        self.input.kind(self.pos)
    }

    /// The token `n` places ahead.
    pub(crate) fn nth(&self, n: usize) -> SyntaxKind {
        self.input.kind(self.pos + n)
    }

    pub(crate) fn at(&self, kind: SyntaxKind) -> bool {
        self.current() == kind
    }

    /// The current token if it is on the line of the statement; `EOF` if the line has ended.
    pub(crate) fn here(&self) -> SyntaxKind {
        if self.at_line_end() { EOF } else { self.current() }
    }

    /// As [`Parser::here`], for the next token.
    pub(crate) fn next_here(&self) -> SyntaxKind {
        let next = self.pos + 1;
        if self.at_line_end() || self.starts_line(next) { EOF } else { self.input.kind(next) }
    }

    /// The line of the statement ends before the current token.
    pub(crate) fn at_line_end(&self) -> bool {
        self.pos != self.statement && self.starts_line(self.pos) || self.at_code_end()
    }

    /// The content of `<Code>` ends here.
    pub(crate) fn at_code_end(&self) -> bool {
        matches!(self.current(), L_ANGLE_SLASH | L_ANGLE | EOF)
    }

    pub(crate) fn position(&self) -> usize {
        self.pos
    }

    /// Indentation of the line that the token at `pos` starts; 0 within a line.
    pub(crate) fn indent(&self, pos: usize) -> Indent {
        if self.starts_line(pos) { self.input.indent(pos) } else { Indent::ZERO }
    }

    pub(crate) fn starts_line(&self, pos: usize) -> bool {
        self.input.indent(pos).starts_line()
    }

    /// The positions of the tokens on the line of the statement.
    pub(crate) fn line(&self) -> impl Iterator<Item = usize> {
        let is_first = |at: usize| at == self.statement;
        let on_line = move |&at: &usize| (is_first(at) || !self.starts_line(at)) && self.kind_at(at) != EOF;
        (self.statement..).take_while(on_line)
    }

    pub(crate) fn text(&self) -> &'i str {
        self.input.text(self.pos)
    }

    pub(crate) fn text_at(&self, pos: usize) -> &'i str {
        self.input.text(pos)
    }

    pub(crate) fn kind_at(&self, pos: usize) -> SyntaxKind {
        self.input.kind(pos)
    }

    /// Range of the token at `pos`; at the end of the text an empty range.
    pub(crate) fn range(&self, pos: usize) -> TextRange {
        self.input.range(pos)
    }

    /// The range of the current token and the following one.
    pub(crate) fn range_of_two(&self) -> TextRange {
        self.range(self.pos).cover(self.range(self.pos + 1))
    }

    /// The empty range after the last token.
    pub(crate) fn range_after(&self) -> TextRange {
        TextRange::empty(self.input.range(self.pos.saturating_sub(1)).end())
    }

    /// The two tokens from `pos` on touch each other.
    pub(crate) fn touches_next(&self, pos: usize) -> bool {
        self.input.range(pos).end() == self.input.range(pos + 1).start()
    }

    // ---- moving ----

    /// Takes the current token into the tree.
    pub(crate) fn bump(&mut self) {
        if self.current() != EOF {
            self.events.push(Event::Token);
            self.pos += 1;
        }
    }

    pub(crate) fn eat(&mut self, kind: SyntaxKind) -> bool {
        let found = self.at(kind);
        if found {
            self.bump();
        }
        found
    }

    /// A new statement starts at the current token.
    pub(crate) fn start_statement(&mut self) {
        self.statement = self.pos;
        self.failed = false;
    }

    /// Runs `inner` for an operand, one level deeper; `None` and a message where the limit is reached.
    pub(crate) fn nested<T>(&mut self, inner: impl FnOnce(&mut Self) -> T) -> Option<T> {
        self.nested_up_to(NESTING_LIMIT, inner)
    }

    /// As [`Parser::nested`], for a block or an element.
    pub(crate) fn nested_block<T>(&mut self, inner: impl FnOnce(&mut Self) -> T) -> Option<T> {
        self.nested_up_to(NESTING_LIMIT - LEFT_TO_EXPRESSIONS, inner)
    }

    fn nested_up_to<T>(&mut self, limit: u32, inner: impl FnOnce(&mut Self) -> T) -> Option<T> {
        if self.depth >= limit {
            self.error(SyntaxErrorKind::NestingTooDeep);
            return None;
        }
        self.depth += 1;
        let value = inner(self);
        self.depth -= 1;
        Some(value)
    }
}
