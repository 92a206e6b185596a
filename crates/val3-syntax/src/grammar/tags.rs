//! Tags and attributes.

use rowan::TextRange;

use crate::error::{SyntaxErrorKind, XmlPart};
use crate::kind::SyntaxKind::*;
use crate::parser::{Marker, Parser};

/// Parses a start tag. Returns whether content follows. An unclosed tag is assumed to have none, except for the root.
pub(super) fn start_tag(p: &mut Parser<'_>, is_root: bool) -> bool {
    let m = p.start();
    let opener = if p.nth(1) == XML_NAME { p.range_of_two() } else { p.range(p.position()) };
    p.bump();
    p.eat(XML_NAME);
    attributes(p);
    let has_content = p.at(R_ANGLE) || is_root && !p.at(SLASH_R_ANGLE);
    close_tag(p, opener, None);
    m.complete(p, START_TAG);
    has_content
}

fn attributes(p: &mut Parser<'_>) {
    let mut seen = Vec::new();
    // An unclosed tag includes the following text, and is reported once.
    let mut told = false;
    loop {
        let (kind, name, range) = (p.current(), p.text(), p.range(p.position()));
        let sound = match kind {
            XML_NAME => {
                seen.push((name, p.position()));
                attribute(p)
            }
            XML_EQ | XML_STRING | ERROR_TOKEN => {
                p.bump();
                false
            }
            _ => break,
        };
        // The lexer has already reported a token that it could not read.
        if !sound && !told && kind != ERROR_TOKEN {
            p.structure_error(SyntaxErrorKind::MalformedAttribute { name: name.to_owned() }, range, None);
        }
        told |= !sound;
    }
    if !told {
        report_duplicates(p, seen);
    }
}

/// Parses an attribute. Returns whether it has a `=` and a value.
fn attribute(p: &mut Parser<'_>) -> bool {
    let m = p.start();
    p.bump();
    let has_equals_sign = p.eat(XML_EQ);
    let sound = has_equals_sign && p.eat(XML_STRING);
    if has_equals_sign && !sound {
        p.eat(ERROR_TOKEN);
    }
    m.complete(p, ATTRIBUTE);
    sound
}

fn report_duplicates(p: &mut Parser<'_>, mut seen: Vec<(&str, usize)>) {
    seen.sort_unstable();
    for pair in seen.windows(2) {
        if let [(first, at), (second, again)] = pair
            && first == second
        {
            let name = (*first).to_owned();
            let first = p.range(*at);
            p.structure_error(SyntaxErrorKind::DuplicateAttribute { name }, p.range(*again), Some(first));
        }
    }
}

/// Parses the end tag of the element that starts at `opened`.
pub(super) fn end_tag(p: &mut Parser<'_>, opened: usize) {
    let m = p.start();
    p.bump();
    p.bump();
    finish_end_tag(p, m, opened);
}

fn finish_end_tag(p: &mut Parser<'_>, m: Marker, opened: usize) {
    while matches!(p.current(), XML_NAME | XML_EQ | XML_STRING | ERROR_TOKEN) {
        p.bump();
    }
    close_tag(p, p.range(p.position().saturating_sub(1)), Some(p.range(opened)));
    m.complete(p, END_TAG);
}

/// Parses the `>` of a tag, or reports at `place` that it is missing.
fn close_tag(p: &mut Parser<'_>, place: TextRange, opened: Option<TextRange>) {
    if p.eat(R_ANGLE) || p.eat(SLASH_R_ANGLE) {
        return;
    }
    if !p.at(EOF) || !p.is_end_reported() {
        p.structure_error(SyntaxErrorKind::Unterminated(XmlPart::Tag), place, opened);
    }
    if p.at(EOF) {
        p.mark_end_reported();
    }
}

/// Reports an end tag that closes no element, or that probably closes the element at `meant`.
pub(super) fn unmatched_end_tag(p: &mut Parser<'_>, meant: Option<usize>) {
    let m = p.start();
    let opened = p.position();
    let tag = if p.nth(1) == XML_NAME { p.range_of_two() } else { p.range(opened) };
    p.bump();
    let name = if p.at(XML_NAME) { p.text().to_owned() } else { String::new() };
    finish_end_tag(p, m, opened);
    // A tag at the end of a truncated file may be incomplete.
    if !(p.at(EOF) && p.is_end_reported()) {
        let start = meant.map(|opened| p.range(opened).cover(p.range(opened + 1)));
        p.structure_error(SyntaxErrorKind::UnmatchedEndTag { name }, tag, start);
    }
}
