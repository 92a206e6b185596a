//! Statements that start programs: `call`, `taskCreate`, `taskCreateSync`.

use super::expressions::value;
use super::operands::{argument_list, name_or_path};
use super::rest_of_line::line_end;
use crate::error::{Expected, SyntaxErrorKind};
use crate::kind::SyntaxKind::*;
use crate::parser::Parser;

/// Parses `call name(…)` or `call library:name(…)`.
pub(super) fn call_statement(p: &mut Parser<'_>) {
    let m = p.start();
    p.bump();
    match p.here() {
        IDENT => called_program(p),
        word if word.is_keyword() => p.error(SyntaxErrorKind::ReservedWord { word: p.text().to_owned() }),
        _ => p.expected(Expected::Program),
    }
    line_end(p);
    m.complete(p, CALL_STMT);
}

fn called_program(p: &mut Parser<'_>) {
    let name = name_or_path(p);
    if p.here() != L_PAREN {
        return p.expected(Expected::OpenParen);
    }
    let call = name.precede(p);
    argument_list(p);
    call.complete(p, CALL_EXPR);
}

/// Parses `taskCreate name, priority, program(…)` or `taskCreateSync name, period, overrun, program(…)`.
pub(super) fn task_create_statement(p: &mut Parser<'_>) {
    let m = p.start();
    let more = if p.at(TASK_CREATE_KW) { 2 } else { 3 };
    p.bump();
    value(p);
    for _ in 0..more {
        if p.here() != COMMA {
            p.expected(Expected::Comma);
            break;
        }
        p.bump();
        value(p);
    }
    line_end(p);
    m.complete(p, TASK_CREATE_STMT);
}
