//! Ends of statements, and tokens that are skipped after an error.

use crate::error::SyntaxErrorKind;
use crate::kind::SyntaxKind::*;
use crate::parser::Parser;

/// Ends a statement. Remaining tokens on its line are an error.
pub(super) fn line_end(p: &mut Parser<'_>) {
    if p.at_line_end() {
        return;
    }
    let found = p.text().to_owned();
    p.error(match p.current() {
        R_PAREN | R_BRACK | R_CURLY => {
            SyntaxErrorKind::UnmatchedBracket { bracket: found.chars().next().unwrap_or(')') }
        }
        IDENT | DO_KW if ["then", "do"].contains(&found.to_ascii_lowercase().as_str()) => {
            SyntaxErrorKind::ForeignSpelling { found, instead: "" }
        }
        _ => SyntaxErrorKind::TrailingText { found },
    });
    skip_line(p);
}

/// Moves the rest of the line, at least one token, to an error node.
pub(super) fn skip_line(p: &mut Parser<'_>) {
    let m = p.start();
    if !p.at_code_end() {
        p.bump();
    }
    while !p.at_line_end() {
        p.bump();
    }
    m.complete(p, ERROR);
}

/// Moves the rest of the code to an error node.
pub(super) fn skip_code(p: &mut Parser<'_>) {
    let m = p.start();
    while !p.at_code_end() {
        p.bump();
    }
    m.complete(p, ERROR);
}
