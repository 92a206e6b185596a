//! Whitespace between two pieces.

use rowan::TextRange;
use val3_syntax::SyntaxKind::{self, *};
use val3_syntax::{TextEdit, TextSlice};

use crate::CodeStyle;
use crate::pieces::{FormatToken, breaks_line, gap as blanks};

/// Edit of the whitespace between two pieces. `level` is the indentation level of the line that starts with `after`.
pub(crate) fn gap(
    before: &FormatToken<'_>,
    after: &FormatToken<'_>,
    level: Option<usize>,
    text: &str,
    style: &CodeStyle,
) -> Option<TextEdit> {
    let found = blanks(before, after, text);
    let wanted = if breaks_line(found) {
        line_break(before, after, found, level?, style)?
    } else {
        within_line(before, after, style)?.to_owned()
    };
    // Whitespace written as a character reference is intentional.
    let edit = TextEdit { range: TextRange::new(before.range.end(), after.range.start()), text: wanted };
    (edit.text != found && !found.contains('&')).then_some(edit)
}

/// Edit that corrects the letter case of a keyword.
pub(crate) fn keyword(piece: &FormatToken<'_>) -> Option<TextEdit> {
    let canonical = piece.kind.keyword_text().filter(|_| !piece.frozen)?;
    (piece.text != canonical).then(|| TextEdit { range: piece.range, text: canonical.to_owned() })
}

/// New whitespace around a line break; `None` if it must be kept. Line ends keep their form, and the style limits their
/// number.
fn line_break(
    before: &FormatToken<'_>,
    after: &FormatToken<'_>,
    found: &str,
    level: usize,
    style: &CodeStyle,
) -> Option<String> {
    if before.kind == CDATA_OPEN || after.kind == CDATA_CLOSE || is_mark(before.kind) || is_mark(after.kind) {
        return None;
    }
    let ends = line_ends(found);
    let kept = ends.iter().take(style.blank_lines + 1).copied().collect::<String>();
    let trailing = if before.frozen { leading_blanks(found) } else { "" };
    let indent = if after.frozen {
        found.rsplit(['\n', '\r']).next().unwrap_or("").to_owned()
    } else {
        style.indent.text(level)
    };
    Some([trailing, &kept, &indent].concat())
}

/// Whether the token is an XML comment or a conflict marker.
fn is_mark(kind: SyntaxKind) -> bool {
    matches!(kind, XML_COMMENT | CONFLICT_MARKER)
}

fn leading_blanks(gap: &str) -> &str {
    gap.split(['\n', '\r']).next().unwrap_or("")
}

/// Line ends in the whitespace, in their original form.
fn line_ends(gap: &str) -> Vec<&str> {
    let mut ends = Vec::new();
    let mut rest = gap;
    while let Some(at) = rest.find(['\n', '\r']) {
        let tail = rest.part(at..);
        let len = if tail.starts_with("\r\n") { 2 } else { 1 };
        ends.push(tail.part(..len));
        rest = tail.part(len..);
    }
    ends
}

/// New whitespace between two pieces of a line; `None` if the whitespace must be kept.
fn within_line(before: &FormatToken<'_>, after: &FormatToken<'_>, style: &CodeStyle) -> Option<&'static str> {
    if before.frozen || after.frozen || after.kind == COMMENT || is_outside(before.kind) || is_outside(after.kind) {
        return None;
    }
    Some(if has_blank(before, after, style) { " " } else { "" })
}

/// Whether the token delimits the code.
fn is_outside(kind: SyntaxKind) -> bool {
    matches!(kind, CDATA_OPEN | CDATA_CLOSE | BEGIN_KW | END_KW) || is_mark(kind)
}

fn has_blank(before: &FormatToken<'_>, after: &FormatToken<'_>, style: &CodeStyle) -> bool {
    match (before.kind, after.kind) {
        (L_PAREN | L_BRACK | L_CURLY | DOT | COLON, _)
        | (_, R_PAREN | R_BRACK | R_CURLY | COMMA | DOT | COLON | L_BRACK) => false,
        (_, L_PAREN) if after.parent == ARG_LIST => false,
        (COMMA, _) => style.after_comma,
        _ if is_unary(before) => false,
        // Without a space, two minus signs would look like one sign.
        (MINUS, MINUS) => true,
        _ if is_assignment(before) || is_assignment(after) => style.around_assignment,
        _ if is_word(before) || is_word(after) => true,
        _ if is_operator(before) || is_operator(after) => style.around_operators,
        _ => true,
    }
}

fn is_unary(piece: &FormatToken<'_>) -> bool {
    piece.parent == PREFIX_EXPR && matches!(piece.kind, MINUS | BANG)
}

fn is_assignment(piece: &FormatToken<'_>) -> bool {
    piece.kind == EQ
}

/// Whether the token is a keyword that is no value, or `?`.
fn is_word(piece: &FormatToken<'_>) -> bool {
    piece.kind == QUESTION || piece.kind.is_keyword() && !matches!(piece.kind, TRUE_KW | FALSE_KW)
}

fn is_operator(piece: &FormatToken<'_>) -> bool {
    piece.parent == BIN_EXPR
}
