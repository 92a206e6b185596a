//! Statements, one on each line.

use super::blocks::{BlockKind, Blocks, Ending};
use super::expressions::{expression, value};
use super::rest_of_line::{line_end, skip_code, skip_line};
use super::{control, switch, tasks};
use crate::error::{Expected, SyntaxErrorKind};
use crate::kind::SyntaxKind::*;
use crate::parser::Parser;

/// Parses statements up to a keyword that ends the innermost block, an outer block or the program.
pub(super) fn statements(p: &mut Parser<'_>, blocks: &mut Blocks) {
    let m = p.start();
    while !p.at_code_end() {
        p.start_statement();
        match blocks.ending(p) {
            Ending::Over => break,
            Ending::Stray => stray_keyword(p, blocks),
            Ending::None => {
                blocks.note_layout(p);
                statement(p, blocks);
            }
        }
    }
    m.complete(p, BLOCK);
}

/// Parses a statement, up to the end of its line or block.
pub(super) fn statement(p: &mut Parser<'_>, blocks: &mut Blocks) {
    match p.current() {
        IF_KW | WHILE_KW | DO_KW | FOR_KW | SWITCH_KW => block_statement(p, blocks),
        RETURN_KW => return_statement(p),
        CALL_KW => tasks::call_statement(p),
        TASK_CREATE_KW | TASK_CREATE_SYNC_KW => tasks::task_create_statement(p),
        QUESTION => print_statement(p),
        BEGIN_KW => {
            p.expected(Expected::Statement);
            skip_line(p);
        }
        _ => expression_statement(p),
    }
}

fn block_statement(p: &mut Parser<'_>, blocks: &mut Blocks) {
    let read = p.nested_block(|p| match p.current() {
        WHILE_KW => control::while_statement(p, blocks),
        DO_KW => control::do_statement(p, blocks),
        FOR_KW => control::for_statement(p, blocks),
        SWITCH_KW | CASE_KW | DEFAULT_KW => switch::switch_statement(p, blocks),
        _ => control::if_statement(p, blocks),
    });
    if read.is_none() {
        blocks.skipped = true;
        skip_code(p);
    }
}

/// Reports a keyword that ends or continues a block which is not open.
pub(super) fn stray_keyword(p: &mut Parser<'_>, blocks: &mut Blocks) {
    let keyword = p.current();
    p.error(match keyword {
        BREAK_KW => SyntaxErrorKind::BreakOutsideSwitch,
        CASE_KW | DEFAULT_KW => SyntaxErrorKind::CaseOutsideSwitch,
        END_KW => SyntaxErrorKind::CodeOutsideBody,
        _ => SyntaxErrorKind::UnmatchedBlockEnd {
            found: keyword.keyword_text().unwrap_or(""),
            opener: BlockKind::of(keyword).map_or("", |kind| kind.names().0),
        },
    });
    match keyword {
        // The rest of such a block belongs to the same mistake.
        ELSE_KW | ELSE_IF_KW | CASE_KW | DEFAULT_KW => block_statement(p, blocks),
        _ => skip_line(p),
    }
}

fn return_statement(p: &mut Parser<'_>) {
    let m = p.start();
    p.bump();
    if !p.at_line_end() {
        p.error(SyntaxErrorKind::ReturnValue);
        skip_line(p);
    }
    m.complete(p, RETURN_STMT);
}

fn print_statement(p: &mut Parser<'_>) {
    let m = p.start();
    p.bump();
    value(p);
    line_end(p);
    m.complete(p, PRINT_STMT);
}

/// Parses an assignment, an instruction call, or a value without effect.
fn expression_statement(p: &mut Parser<'_>) {
    let m = p.start();
    let Some(left) = expression(p) else {
        if !p.failed() {
            p.expected(Expected::Statement);
        }
        m.abandon(p);
        return skip_line(p);
    };
    let kind = match p.here() {
        EQ => {
            assigned_value(p);
            ASSIGN_STMT
        }
        EOF | R_PAREN | R_BRACK | R_CURLY => EXPR_STMT,
        _ => {
            if matches!(left.kind(), NAME_REF | LIBRARY_PATH) && !p.failed() {
                p.expected(Expected::AssignmentOrCall);
            }
            EXPR_STMT
        }
    };
    line_end(p);
    m.complete(p, kind);
}

/// Parses `= value`, or `= place = value` in a chained assignment.
fn assigned_value(p: &mut Parser<'_>) {
    p.bump();
    let chained = p.nested(|p| {
        let link = p.start();
        if expression(p).is_none() && !p.failed() {
            p.expected(Expected::Expression);
        }
        if p.here() == EQ {
            assigned_value(p);
            link.complete(p, ASSIGN_EXPR);
        } else {
            link.abandon(p);
        }
    });
    if chained.is_none() {
        skip_line(p);
    }
}
