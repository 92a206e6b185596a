//! Block matching: which keyword closes which block.
//!
//! The first pass uses keywords only. If the blocks do not balance, further passes match by indentation or more
//! strictly ([`Matching`]), and the pass with the fewest errors is kept. A missing `endIf` is therefore reported where
//! the indentation ends, and balanced code is never reported for its indentation.

use rowan::TextRange;

use super::rest_of_line::skip_line;
use crate::error::SyntaxErrorKind;
use crate::kind::SyntaxKind::{self, *};
use crate::lexer::Indent;
use crate::parser::{Matching, Parser};

/// Kind of block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum BlockKind {
    If,
    While,
    Do,
    For,
    Switch,
    Case,
}

impl BlockKind {
    /// Returns the keywords that open and close the block.
    pub(super) fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::If => ("if", "endIf"),
            Self::While => ("while", "endWhile"),
            Self::Do => ("do", "until"),
            Self::For => ("for", "endFor"),
            Self::Switch => ("switch", "endSwitch"),
            Self::Case => ("case", "break"),
        }
    }

    /// Returns the kind of block that a keyword ends or continues.
    pub(super) fn of(keyword: SyntaxKind) -> Option<Self> {
        Some(match keyword {
            END_IF_KW | ELSE_KW | ELSE_IF_KW => Self::If,
            END_WHILE_KW => Self::While,
            UNTIL_KW => Self::Do,
            END_FOR_KW => Self::For,
            END_SWITCH_KW | CASE_KW | DEFAULT_KW => Self::Switch,
            BREAK_KW => Self::Case,
            _ => return None,
        })
    }
}

#[derive(Debug, Clone, Copy)]
struct OpenBlock {
    kind: BlockKind,
    indent: Indent,
    keyword: TextRange,
    /// Whether the opening keyword is missing, which was already reported.
    headless: bool,
    layout: BlockIndentation,
}

/// Indentation of the lines in a block, which may show its end.
#[derive(Debug, Clone, Copy)]
enum BlockIndentation {
    /// No line so far.
    Unknown,
    /// The lines are not indented, so that the end is unknown.
    Flat,
    /// The lines are indented.
    Indented,
    /// The first line outside of the block, before which the end is expected.
    Dedented(TextRange),
}

/// Stack of open blocks.
pub(super) struct Blocks {
    open: Vec<OpenBlock>,
    /// Token position of the final `end` of the code.
    last_end: Option<usize>,
    /// Whether the rest of the code was skipped, so that missing block ends are not reported.
    pub(super) skipped: bool,
}

/// Effect of a keyword on a sequence of statements.
pub(super) enum Ending {
    /// The keyword ends or continues the innermost or an outer block, so that the sequence ends.
    Over,
    /// The keyword belongs to no open block.
    Stray,
    /// The token is no such keyword.
    None,
}

impl Blocks {
    pub(super) fn new(last_end: Option<usize>) -> Self {
        Self { open: Vec::new(), last_end, skipped: false }
    }

    /// Opens a block at the current keyword.
    pub(super) fn push(&mut self, p: &Parser<'_>, kind: BlockKind, headless: bool) {
        let at = p.position();
        let (indent, keyword) = (p.indent(at), p.range(at));
        self.open.push(OpenBlock { kind, indent, keyword, headless, layout: BlockIndentation::Unknown });
    }

    /// Closes the innermost block with its own keyword.
    pub(super) fn pop(&mut self) {
        self.open.pop();
    }

    /// Whether the current keyword ends or continues the innermost block.
    pub(super) fn take_own(&mut self, p: &Parser<'_>) -> bool {
        let Some(kind) = self.open.last().map(|open| open.kind) else { return false };
        let own = BlockKind::of(p.current()) == Some(kind) && !self.skips_innermost(p, kind);
        if own && let Some(open) = self.open.last_mut() {
            open.layout = BlockIndentation::Unknown;
        }
        own
    }

    /// Closes the innermost block without its keyword and reports that.
    pub(super) fn give_up(&mut self, p: &mut Parser<'_>) {
        let Some(open) = self.open.pop() else { return };
        // If the file is truncated, only its innermost element is reported.
        if open.headless || self.skipped || p.at(EOF) {
            return;
        }
        let (block, missing) = open.kind.names();
        let kind = match open.kind {
            BlockKind::Case => SyntaxErrorKind::MissingBreak,
            _ => SyntaxErrorKind::UnclosedBlock { block, missing },
        };
        if is_wrong_end(p, &open) {
            p.structure_error(kind, p.range(p.position()), Some(open.keyword));
            return skip_line(p);
        }
        p.structure_error(kind, place_of_end(p, &open), Some(open.keyword));
        // A lone `end` in the middle of the code was meant to end this block.
        if p.at(END_KW) && self.last_end != Some(p.position()) {
            p.bump();
        }
    }

    /// Returns the effect of the current keyword on the statements of the innermost block.
    pub(super) fn ending(&self, p: &Parser<'_>) -> Ending {
        let keyword = p.current();
        let over = match (BlockKind::of(keyword), self.open.last()) {
            (None, _) if keyword != END_KW => return Ending::None,
            (None, open) => self.ends_here(p, open),
            (_, None) => false,
            (Some(kind), Some(open)) if open.kind == kind => !self.is_misplaced(p, open),
            (Some(kind), Some(open)) => self.is_of_outer(p, kind, open) || is_wrong_end(p, open),
        };
        if over { Ending::Over } else { Ending::Stray }
    }

    /// Whether the current `end` ends the program, or the innermost block by mistake.
    fn ends_here(&self, p: &Parser<'_>, innermost: Option<&OpenBlock>) -> bool {
        let is_last = self.last_end.is_none() || self.last_end == Some(p.position());
        let deeper = |open: &OpenBlock| p.matching == Matching::Guided && p.indent(p.position()) > open.indent;
        is_last || innermost.is_some_and(|open| !deeper(open))
    }

    /// Whether a keyword of `kind` belongs to an outer block.
    fn is_of_outer(&self, p: &Parser<'_>, kind: BlockKind, innermost: &OpenBlock) -> bool {
        let mut outer = self.open.iter().rev().skip(1).filter(|open| open.kind == kind);
        let indent = p.indent(p.position());
        match p.matching {
            Matching::Plain => outer.next().is_some(),
            Matching::Guided if indent < innermost.indent => outer.next().is_some(),
            Matching::Guided => outer.any(|open| lines_up(p, open) && indent <= innermost.indent),
            Matching::Strict => false,
        }
    }

    /// Whether, with matching by indentation, the keyword is indented more than the block that it would end.
    fn is_misplaced(&self, p: &Parser<'_>, open: &OpenBlock) -> bool {
        p.matching == Matching::Guided && !lines_up(p, open) && p.indent(p.position()) > open.indent
    }

    /// Whether, with matching by indentation, the keyword is aligned with an outer block, so that the innermost block
    /// is unclosed.
    fn skips_innermost(&self, p: &Parser<'_>, kind: BlockKind) -> bool {
        let mut outer = self.open.iter().rev().skip(1);
        p.matching == Matching::Guided
            && self.open.last().is_some_and(|open| open.indent > p.indent(p.position()))
            && outer.any(|open| open.kind == kind && lines_up(p, open))
    }

    /// Records the indentation of the statement at the current token.
    pub(super) fn note_layout(&mut self, p: &Parser<'_>) {
        let at = p.position();
        if let Some(open) = self.open.last_mut()
            && p.starts_line(at)
        {
            let deeper = p.indent(at) > open.indent;
            open.layout = match open.layout {
                BlockIndentation::Unknown if deeper => BlockIndentation::Indented,
                BlockIndentation::Unknown => BlockIndentation::Flat,
                BlockIndentation::Indented if !deeper => BlockIndentation::Dedented(p.range(at)),
                known => known,
            };
        }
    }
}

/// Whether the current keyword is aligned with the block's opening keyword; `case` and `default` may be indented more.
fn lines_up(p: &Parser<'_>, open: &OpenBlock) -> bool {
    let indent = p.indent(p.position());
    indent == open.indent || indent > open.indent && matches!(p.current(), CASE_KW | DEFAULT_KW)
}

/// Whether, with matching by indentation, the current keyword is aligned with the block but ends another kind of block.
fn is_wrong_end(p: &Parser<'_>, open: &OpenBlock) -> bool {
    let ends = matches!(p.current(), END_IF_KW | END_WHILE_KW | UNTIL_KW | END_FOR_KW | END_SWITCH_KW);
    let other = open.kind != BlockKind::Case && BlockKind::of(p.current()) != Some(open.kind);
    p.matching == Matching::Guided && ends && other && !open.headless && p.indent(p.position()) == open.indent
}

/// Returns the place for the missing end of a block.
fn place_of_end(p: &Parser<'_>, open: &OpenBlock) -> TextRange {
    match open.layout {
        BlockIndentation::Dedented(line) => line,
        _ if p.at_code_end() => p.range_after(),
        _ => p.range(p.position()),
    }
}
