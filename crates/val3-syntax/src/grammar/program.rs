//! The content of `<Code>`: `begin … end`.

use super::blocks::Blocks;
use super::rest_of_line::skip_code;
use super::statements::statements;
use crate::error::SyntaxErrorKind;
use crate::kind::SyntaxKind::*;
use crate::parser::Parser;

/// Parses the code of a program; `opened` is the position of the start tag.
pub(super) fn code(p: &mut Parser<'_>, opened: usize) {
    let m = p.start();
    p.start_statement();
    if p.at_code_end() {
        p.error_at(SyntaxErrorKind::NoCode, p.range(opened).cover(p.range(opened + 1)), None);
    } else {
        p.best_reading(body);
    }
    m.complete(p, CODE);
    p.start_statement();
}

fn body(p: &mut Parser<'_>) {
    let end = code_end(p);
    if !p.at(BEGIN_KW) {
        before_begin(p, end);
    }
    p.eat(BEGIN_KW);
    let mut blocks = Blocks::new(last_end(p, end));
    statements(p, &mut blocks);
    // If the file is truncated, only its innermost element is reported.
    if !p.eat(END_KW) && !p.at(EOF) && !blocks.skipped {
        p.structure_error(SyntaxErrorKind::MissingEnd, p.range_after(), None);
    }
    text_after_end(p);
}

/// Returns the position after the last token of the code.
fn code_end(p: &Parser<'_>) -> usize {
    let mut at = p.position();
    while !matches!(p.kind_at(at), L_ANGLE_SLASH | L_ANGLE | EOF) {
        at += 1;
    }
    at
}

/// Returns the position of the last token if it is the `end` of the program.
fn last_end(p: &Parser<'_>, end: usize) -> Option<usize> {
    let last = end.checked_sub(1)?;
    (p.kind_at(last) == END_KW).then_some(last)
}

/// Reports code before `begin`, or a missing `begin`.
fn before_begin(p: &mut Parser<'_>, end: usize) {
    let start = p.position();
    let begin = (start..end).find(|&at| p.kind_at(at) == BEGIN_KW && p.starts_line(at));
    let Some(begin) = begin else {
        return p.structure_error(SyntaxErrorKind::MissingBegin, p.range(start), None);
    };
    let range = p.range(start).cover(p.range(begin.saturating_sub(1)));
    p.structure_error(SyntaxErrorKind::CodeOutsideBody, range, None);
    let m = p.start();
    while p.position() < begin {
        p.bump();
    }
    m.complete(p, ERROR);
}

fn text_after_end(p: &mut Parser<'_>) {
    if p.at_code_end() {
        return;
    }
    let start = p.position();
    skip_code(p);
    let range = p.range(start).cover(p.range(p.position().saturating_sub(1)));
    p.structure_error(SyntaxErrorKind::CodeOutsideBody, range, None);
}
