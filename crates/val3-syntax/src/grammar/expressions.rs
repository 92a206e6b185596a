//! Expressions, parsed by operator precedence (manual 3.1.2 to 3.4.2, 9.2.2, 9.3.3).

use super::operands::postfix;
use super::rest_of_line::skip_line;
use crate::error::{Expected, SyntaxErrorKind};
use crate::kind::SyntaxKind::{self, *};
use crate::lexer::decode_entities;
use crate::parser::{Completed, NESTING_LIMIT, Parser};

/// Returns the precedence of a binary operator. Operators with equal precedence associate to the left.
fn precedence(kind: SyntaxKind) -> Option<u8> {
    Some(match kind {
        OR_KW => 1,
        AND_KW => 2,
        XOR_KW => 3,
        EQ2 | NEQ => 4,
        LT | LE | GT | GE => 5,
        PLUS | MINUS => 6,
        STAR | SLASH | PERCENT => 7,
        _ => return None,
    })
}

/// Parses an expression whose value is needed. A missing expression is an error, and so is an assignment.
pub(super) fn value(p: &mut Parser<'_>) {
    let Some(left) = expression(p) else {
        if !p.failed() {
            p.expected(Expected::Expression);
        }
        return;
    };
    if p.here() == EQ {
        p.error(SyntaxErrorKind::AssignmentInExpression);
        let m = left.precede(p);
        p.bump();
        expression(p);
        m.complete(p, ASSIGN_EXPR);
    }
}

/// Parses an expression; `None` if none starts here.
pub(super) fn expression(p: &mut Parser<'_>) -> Option<Completed> {
    operand(p, |p| binary(p, 1))
}

/// Parses a part of an expression at the next nesting level. If this exceeds the nesting limit, the rest of the line is
/// skipped.
fn operand(p: &mut Parser<'_>, read: impl FnOnce(&mut Parser<'_>) -> Option<Completed>) -> Option<Completed> {
    p.nested(read).unwrap_or_else(|| {
        skip_line(p);
        None
    })
}

/// Like [`operand`], but reports a missing operand.
fn needed(p: &mut Parser<'_>, read: impl FnOnce(&mut Parser<'_>) -> Option<Completed>) {
    if operand(p, read).is_none() && !p.failed() {
        p.expected(Expected::Expression);
    }
}

/// Whether the tree has its maximum height, so that the current operator and the rest of its line are skipped.
pub(super) fn is_too_high(p: &mut Parser<'_>, below: Completed) -> bool {
    let too_high = below.height() >= NESTING_LIMIT;
    if too_high {
        p.error(SyntaxErrorKind::NestingTooDeep);
        skip_line(p);
    }
    too_high
}

fn binary(p: &mut Parser<'_>, min: u8) -> Option<Completed> {
    let mut left = unary(p)?;
    while let Some((level, tokens)) = binary_operator(p) {
        if level < min || is_too_high(p, left) {
            break;
        }
        let m = left.precede(p);
        for _ in 0..tokens {
            p.bump();
        }
        needed(p, |p| binary(p, level + 1));
        left = m.complete(p, BIN_EXPR);
    }
    Some(left)
}

/// Returns the precedence and the length in tokens of the current binary operator. Foreign spellings are reported and
/// accepted as their VAL 3 operators.
fn binary_operator(p: &mut Parser<'_>) -> Option<(u8, usize)> {
    let kind = p.here();
    if kind == LT && p.next_here() == GT && p.touches_next(p.position()) {
        let kind = SyntaxErrorKind::ForeignSpelling { found: "<>".to_owned(), instead: "!=" };
        p.error_at(kind, p.range_of_two(), None);
        return Some((4, 2));
    }
    if kind == ERROR_TOKEN {
        let (instead, level) = match p.text() {
            "&&" | "&amp;&amp;" => ("and", 2),
            "||" => ("or", 1),
            _ => return None,
        };
        foreign(p, instead);
        return Some((level, 1));
    }
    precedence(kind).map(|level| (level, 1))
}

fn foreign(p: &mut Parser<'_>, instead: &'static str) {
    let found = decode_entities(p.text()).into_owned();
    p.error(SyntaxErrorKind::ForeignSpelling { found, instead });
}

fn unary(p: &mut Parser<'_>) -> Option<Completed> {
    match p.here() {
        MINUS | BANG => prefix(p),
        IDENT if is_foreign_not(p) => {
            foreign(p, "!");
            prefix(p)
        }
        _ => postfix(p),
    }
}

/// Whether the tokens are `not x`: the name `not` directly followed by an operand.
fn is_foreign_not(p: &Parser<'_>) -> bool {
    p.text().eq_ignore_ascii_case("not") && matches!(p.next_here(), IDENT | TRUE_KW | FALSE_KW | NUMBER | STRING)
}

fn prefix(p: &mut Parser<'_>) -> Option<Completed> {
    let m = p.start();
    if matches!(p.next_here(), MINUS | BANG) {
        p.error_at(SyntaxErrorKind::DoubleUnary, p.range_of_two(), None);
    }
    p.bump();
    needed(p, unary);
    Some(m.complete(p, PREFIX_EXPR))
}
