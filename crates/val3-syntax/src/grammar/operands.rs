//! Operands of expressions: literals, names, brackets, and suffixes of names.

use super::expressions::{is_too_high, value};
use crate::error::{Expected, SyntaxErrorKind};
use crate::kind::SyntaxKind::{self, *};
use crate::parser::{Completed, Parser};

/// Parses a variable with its indexes and fields, as for the counter of `for`.
pub(super) fn place(p: &mut Parser<'_>) {
    if p.here() != IDENT || postfix(p).is_none() {
        p.expected(Expected::Name);
    }
}

/// Parses a value with its suffixes: indexes, fields, arguments.
pub(super) fn postfix(p: &mut Parser<'_>) -> Option<Completed> {
    let mut base = atom(p)?;
    loop {
        let kind = match p.here() {
            L_BRACK => INDEX_EXPR,
            DOT => FIELD_EXPR,
            L_PAREN if matches!(base.kind(), NAME_REF | LIBRARY_PATH) => CALL_EXPR,
            _ => return Some(base),
        };
        if is_too_high(p, base) {
            return Some(base);
        }
        let m = base.precede(p);
        match kind {
            INDEX_EXPR => index_list(p),
            FIELD_EXPR => field(p),
            _ => argument_list(p),
        }
        base = m.complete(p, kind);
    }
}

fn field(p: &mut Parser<'_>) {
    p.bump();
    if p.here() == IDENT {
        name(p);
    } else {
        p.expected(Expected::Field);
    }
}

fn atom(p: &mut Parser<'_>) -> Option<Completed> {
    match p.here() {
        NUMBER | STRING | TRUE_KW | FALSE_KW => {
            let m = p.start();
            p.bump();
            Some(m.complete(p, LITERAL))
        }
        IDENT => Some(name_or_path(p)),
        L_PAREN => Some(parenthesised(p)),
        L_CURLY => Some(struct_literal(p)),
        kind if kind.is_keyword() && !is_separator(kind) => {
            let word = p.text().to_owned();
            p.error(SyntaxErrorKind::ReservedWord { word });
            None
        }
        _ => None,
    }
}

/// Whether the keyword separates expressions. Before such a keyword an expression is missing, whereas other keywords
/// are misused names.
fn is_separator(kind: SyntaxKind) -> bool {
    matches!(kind, AND_KW | OR_KW | XOR_KW | TO_KW | STEP_KW)
}

fn name(p: &mut Parser<'_>) -> Completed {
    let m = p.start();
    p.bump();
    m.complete(p, NAME_REF)
}

/// Parses `name` or `library:name`.
pub(super) fn name_or_path(p: &mut Parser<'_>) -> Completed {
    let first = name(p);
    if p.here() != COLON {
        return first;
    }
    let m = first.precede(p);
    p.bump();
    if p.here() == IDENT {
        name(p);
    } else {
        p.expected(Expected::Program);
    }
    m.complete(p, LIBRARY_PATH)
}

fn parenthesised(p: &mut Parser<'_>) -> Completed {
    let m = p.start();
    let open = p.position();
    p.bump();
    value(p);
    close_bracket(p, open, R_PAREN, ')');
    m.complete(p, PAREN_EXPR)
}

/// Parses the closing bracket, or reports that it is missing.
fn close_bracket(p: &mut Parser<'_>, open: usize, close: SyntaxKind, missing: char) {
    if p.here() == close {
        return p.bump();
    }
    // Only the first error of a line is reported. Looking ahead once for each line keeps the time linear.
    if p.failed() {
        return;
    }
    let after = p.at_line_end();
    let range = if after { p.range_after() } else { p.range(p.position()) };
    let closed_later = !after && is_ahead(p, close) && surplus(p, close) >= 0;
    let kind = match p.here() {
        found @ (R_PAREN | R_BRACK | R_CURLY) if closed_later && surplus(p, found) > 0 => {
            SyntaxErrorKind::UnmatchedBracket { bracket: p.text().chars().next().unwrap_or(missing) }
        }
        R_PAREN | R_BRACK | R_CURLY => SyntaxErrorKind::UnclosedBracket { missing },
        _ if closed_later => SyntaxErrorKind::TrailingText { found: p.text().to_owned() },
        _ => SyntaxErrorKind::UnclosedBracket { missing },
    };
    let related = (!matches!(kind, SyntaxErrorKind::UnmatchedBracket { .. })).then(|| p.range(open));
    p.error_at(kind, range, related);
    if closed_later {
        skip_to(p, close);
    }
}

/// Whether a token of `kind` follows on this line.
fn is_ahead(p: &Parser<'_>, kind: SyntaxKind) -> bool {
    (p.position()..).take_while(|&at| !p.starts_line(at) && p.kind_at(at) != EOF).any(|at| p.kind_at(at) == kind)
}

/// Returns the number of closing brackets of kind `close` on this line minus the number of opening ones.
fn surplus(p: &Parser<'_>, close: SyntaxKind) -> isize {
    let open = match close {
        R_PAREN => L_PAREN,
        R_BRACK => L_BRACK,
        _ => L_CURLY,
    };
    let count = |kind| p.line().filter(|&at| p.kind_at(at) == kind).count().cast_signed();
    count(close) - count(open)
}

/// Skips to the closing bracket on this line and consumes it, so that parsing continues after it.
fn skip_to(p: &mut Parser<'_>, close: SyntaxKind) {
    let m = p.start();
    while p.here() != close && !p.at_line_end() {
        p.bump();
    }
    m.complete(p, ERROR);
    p.eat(close);
}

/// Parses `[index, …]`.
fn index_list(p: &mut Parser<'_>) {
    let open = p.position();
    p.bump();
    value(p);
    while p.here() == COMMA {
        p.bump();
        value(p);
    }
    close_bracket(p, open, R_BRACK, ']');
}

/// Parses `(argument, …)`.
pub(super) fn argument_list(p: &mut Parser<'_>) {
    let m = p.start();
    let open = p.position();
    p.bump();
    if p.here() != R_PAREN {
        value(p);
        while p.here() == COMMA {
            p.bump();
            value(p);
        }
    }
    close_bracket(p, open, R_PAREN, ')');
    m.complete(p, ARG_LIST);
}

/// Parses `{value, …}`. A value omitted between commas means zero (manual 2.4.2).
fn struct_literal(p: &mut Parser<'_>) -> Completed {
    let m = p.start();
    let open = p.position();
    p.bump();
    loop {
        if !matches!(p.here(), COMMA | R_CURLY | EOF) {
            value(p);
        }
        if p.here() != COMMA {
            break;
        }
        p.bump();
    }
    close_bracket(p, open, R_CURLY, '}');
    m.complete(p, STRUCT_LITERAL)
}
