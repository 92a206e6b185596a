//! `if`, `while`, `do` and `for`.

use rowan::TextRange;

use super::blocks::{BlockKind, Blocks};
use super::expressions::value;
use super::operands::place;
use super::rest_of_line::line_end;
use super::statements::statements;
use crate::error::{Expected, SyntaxErrorKind};
use crate::kind::SyntaxKind::{self, *};
use crate::parser::Parser;

/// Parses the lines inside the innermost block. Returns whether the block's own keyword follows.
pub(super) fn inner(p: &mut Parser<'_>, blocks: &mut Blocks) -> bool {
    statements(p, blocks);
    let own = blocks.take_own(p);
    if own {
        p.start_statement();
    }
    own
}

/// Closes the innermost block with the current keyword, or reports that the keyword is missing.
pub(super) fn close(p: &mut Parser<'_>, blocks: &mut Blocks, own: bool) {
    if own {
        blocks.pop();
        p.bump();
        line_end(p);
    } else {
        blocks.give_up(p);
    }
}

/// The final branch of a statement: `else` or `default`.
#[derive(Default)]
pub(super) struct LastBranch {
    keyword: Option<TextRange>,
    told: bool,
}

impl LastBranch {
    pub(super) fn found(&mut self, keyword: TextRange) {
        self.keyword = self.keyword.or(Some(keyword));
    }

    /// Reports that the current keyword starts a branch after the final branch, once for a statement.
    pub(super) fn check(&mut self, p: &mut Parser<'_>, kind: SyntaxErrorKind) {
        if self.keyword.is_some() && !self.told {
            self.told = true;
            p.error_at(kind, p.range(p.position()), self.keyword);
        }
    }
}

/// Parses the current keyword, a condition, and the end of the line.
pub(super) fn condition(p: &mut Parser<'_>) {
    p.bump();
    value(p);
    line_end(p);
}

/// Parses `if`; after a missing `if`, the rest from `else` or `elseIf` on.
pub(super) fn if_statement(p: &mut Parser<'_>, blocks: &mut Blocks) {
    let m = p.start();
    let headless = !p.at(IF_KW);
    blocks.push(p, BlockKind::If, headless);
    let mut own = headless;
    if !headless {
        condition(p);
        own = inner(p, blocks);
    }
    let mut last = LastBranch::default();
    while own && !p.at(END_IF_KW) {
        let clause = p.start();
        let keyword = p.range(p.position());
        last.check(p, SyntaxErrorKind::ElseAfterElse);
        let kind = clause_head(p);
        if kind == ELSE_CLAUSE {
            last.found(keyword);
        }
        own = inner(p, blocks);
        clause.complete(p, kind);
    }
    close(p, blocks, own);
    m.complete(p, IF_STMT);
}

/// Parses the line of `else` or `elseIf`.
fn clause_head(p: &mut Parser<'_>) -> SyntaxKind {
    if p.at(ELSE_KW) && p.next_here() == IF_KW {
        let kind = SyntaxErrorKind::ForeignSpelling { found: "else if".to_owned(), instead: "elseIf" };
        p.error_at(kind, p.range_of_two(), None);
        p.bump();
        condition(p);
        return ELSE_IF_CLAUSE;
    }
    if p.at(ELSE_IF_KW) {
        condition(p);
        return ELSE_IF_CLAUSE;
    }
    p.bump();
    line_end(p);
    ELSE_CLAUSE
}

pub(super) fn while_statement(p: &mut Parser<'_>, blocks: &mut Blocks) {
    let m = p.start();
    blocks.push(p, BlockKind::While, false);
    condition(p);
    let own = inner(p, blocks);
    close(p, blocks, own);
    m.complete(p, WHILE_STMT);
}

pub(super) fn do_statement(p: &mut Parser<'_>, blocks: &mut Blocks) {
    let m = p.start();
    blocks.push(p, BlockKind::Do, false);
    p.bump();
    line_end(p);
    if inner(p, blocks) {
        blocks.pop();
        condition(p);
    } else {
        blocks.give_up(p);
    }
    m.complete(p, DO_STMT);
}

pub(super) fn for_statement(p: &mut Parser<'_>, blocks: &mut Blocks) {
    let m = p.start();
    blocks.push(p, BlockKind::For, false);
    p.bump();
    for_head(p);
    line_end(p);
    let own = inner(p, blocks);
    close(p, blocks, own);
    m.complete(p, FOR_STMT);
}

/// Parses `counter = start to stop`, optionally with `step size`.
fn for_head(p: &mut Parser<'_>) {
    place(p);
    if p.here() != EQ {
        return p.expected(Expected::ForAssign);
    }
    p.bump();
    value(p);
    if p.here() != TO_KW {
        return p.expected(Expected::ForTo);
    }
    p.bump();
    value(p);
    if p.here() != STEP_KW {
        return;
    }
    p.bump();
    if p.at_line_end() {
        return p.expected(Expected::ForStep);
    }
    value(p);
}
