//! Parser state that the grammar uses: reads tokens, emits events, collects errors.

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

/// Maximum nesting of operands, blocks and elements, and maximum tree height for consecutive operators. The controller
/// accepts much less, and recursive walks over such a tree fit on the stack.
pub(crate) const NESTING_LIMIT: u32 = 200;
/// Part of the nesting limit that blocks and elements leave to the expressions inside them.
const LEFT_TO_EXPRESSIONS: u32 = 100;

/// An event of the grammar, from which the tree is built.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ParseEvent {
    /// A node starts. `parent` is the distance to a later `Start` event of a node that encloses this node; 0 if there
    /// is none.
    Start { kind: SyntaxKind, parent: u32 },
    /// The innermost node ends.
    Finish,
    /// The next token belongs to the innermost node.
    Token,
    /// A node that was abandoned.
    Abandoned,
}

/// Mode in which a keyword selects the block that it ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Matching {
    /// The nearest open block of the keyword's kind.
    Plain,
    /// The nearest open block of the keyword's kind that is aligned with the keyword.
    Guided,
    /// Only the innermost block.
    Strict,
}

/// The parser: a cursor over the non-trivia tokens.
pub(crate) struct Parser<'i> {
    input: &'i Input<'i>,
    pos: usize,
    /// Position of the current statement's first token, which may start a line.
    statement: usize,
    /// Whether an error was reported for this statement, so that the rest of the line is skipped silently.
    failed: bool,
    /// Whether a truncated text was already reported, so that open elements report nothing.
    is_end_reported: bool,
    /// Nesting depth of the current token.
    depth: u32,
    /// Maximum height of the completed nodes in the innermost node.
    height: u32,
    pub(crate) matching: Matching,
    events: Vec<ParseEvent>,
    errors: Vec<SyntaxError>,
}

impl<'i> Parser<'i> {
    /// Creates a parser for a text inside `depth` elements.
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

    pub(crate) fn finish(self) -> (Vec<ParseEvent>, Vec<SyntaxError>) {
        (self.events, self.errors)
    }

    // ---- lookahead ----

    /// Returns the kind of the current token.
    pub(crate) fn current(&self) -> SyntaxKind {
        self.input.kind(self.pos)
    }

    /// Returns the kind of the token `n` positions ahead.
    pub(crate) fn nth(&self, n: usize) -> SyntaxKind {
        self.input.kind(self.pos + n)
    }

    pub(crate) fn at(&self, kind: SyntaxKind) -> bool {
        self.current() == kind
    }

    /// Returns the current token if it is on the statement's line; `EOF` if the line has ended.
    pub(crate) fn here(&self) -> SyntaxKind {
        if self.at_line_end() { EOF } else { self.current() }
    }

    /// Like [`Parser::here`], for the next token.
    pub(crate) fn next_here(&self) -> SyntaxKind {
        let next = self.pos + 1;
        if self.at_line_end() || self.starts_line(next) { EOF } else { self.input.kind(next) }
    }

    /// Whether the statement's line ends before the current token.
    pub(crate) fn at_line_end(&self) -> bool {
        self.pos != self.statement && self.starts_line(self.pos) || self.at_code_end()
    }

    /// Whether the content of `<Code>` ends here.
    pub(crate) fn at_code_end(&self) -> bool {
        matches!(self.current(), L_ANGLE_SLASH | L_ANGLE | EOF)
    }

    pub(crate) fn position(&self) -> usize {
        self.pos
    }

    /// Returns the indentation of the line that the token at `pos` starts; 0 within a line.
    pub(crate) fn indent(&self, pos: usize) -> Indent {
        if self.starts_line(pos) { self.input.indent(pos) } else { Indent::ZERO }
    }

    pub(crate) fn starts_line(&self, pos: usize) -> bool {
        self.input.indent(pos).starts_line()
    }

    /// Returns the positions of the tokens on the statement's line.
    pub(crate) fn line(&self) -> impl Iterator<Item = usize> {
        let until_line_start = (self.statement..).take_while(move |at| *at == self.statement || !self.starts_line(*at));
        until_line_start.take_while(move |at| self.kind_at(*at) != EOF)
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

    /// Returns the range of the token at `pos`; an empty range at the end of the text.
    pub(crate) fn range(&self, pos: usize) -> TextRange {
        self.input.range(pos)
    }

    /// Returns the range of the current and the next token.
    pub(crate) fn range_of_two(&self) -> TextRange {
        self.range(self.pos).cover(self.range(self.pos + 1))
    }

    /// Returns the empty range after the last consumed token.
    pub(crate) fn range_after(&self) -> TextRange {
        TextRange::empty(self.input.range(self.pos.saturating_sub(1)).end())
    }

    /// Whether no text is between the token at `pos` and the next token.
    pub(crate) fn touches_next(&self, pos: usize) -> bool {
        self.input.range(pos).end() == self.input.range(pos + 1).start()
    }

    // ---- consumption ----

    /// Adds the current token to the tree and advances.
    pub(crate) fn bump(&mut self) {
        if self.current() != EOF {
            self.events.push(ParseEvent::Token);
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

    /// Starts a statement at the current token.
    pub(crate) fn start_statement(&mut self) {
        self.statement = self.pos;
        self.failed = false;
    }

    /// Runs `inner` for an operand, one level deeper; reports an error and returns `None` at the nesting limit.
    pub(crate) fn nested<T>(&mut self, inner: impl FnOnce(&mut Self) -> T) -> Option<T> {
        self.nested_up_to(NESTING_LIMIT, inner)
    }

    /// Like [`Parser::nested`], for a block or an element.
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
