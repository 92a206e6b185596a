//! Elements, tags and attributes.

use rowan::TextRange;

use super::program::code;
use crate::error::{SyntaxErrorKind, XmlPart};
use crate::kind::SyntaxKind::*;
use crate::parser::{Marker, Parser};

/// A whole file: one element, with anything else around it reported once.
pub(crate) fn file(p: &mut Parser<'_>) {
    let m = p.start();
    let (mut roots, mut strays) = (0, 0);
    let mut names = Vec::new();
    while !p.at(EOF) {
        match p.current() {
            L_ANGLE => {
                roots += 1;
                if roots == 2 {
                    p.structure_error(SyntaxErrorKind::RootElement, p.range(p.position()), None);
                }
                element(p, &mut names);
            }
            L_ANGLE_SLASH => unmatched_end_tag(p),
            ERROR_TOKEN => p.bump(),
            _ => {
                strays += 1;
                if strays == 1 {
                    p.structure_error(SyntaxErrorKind::UnexpectedText, p.range(p.position()), None);
                }
                p.bump();
            }
        }
    }
    if roots == 0 && strays == 0 {
        p.structure_error(SyntaxErrorKind::RootElement, p.range(p.position()), None);
    }
    m.complete(p, XML_FILE);
}

/// An element; `names` are the names of the elements around it.
fn element<'i>(p: &mut Parser<'i>, names: &mut Vec<&'i str>) {
    p.start_statement();
    if p.nested(|p| element_inner(p, names)).is_none() {
        p.tell_end();
        let m = p.start();
        while !p.at(EOF) {
            p.bump();
        }
        m.complete(p, ERROR);
    }
}

fn element_inner<'i>(p: &mut Parser<'i>, names: &mut Vec<&'i str>) {
    let m = p.start();
    let opened = p.position();
    let name = if p.nth(1) == XML_NAME { p.text_at(opened + 1) } else { "" };
    if start_tag(p) {
        names.push(name);
        if matches!(name, "Code" | "code") {
            code(p, opened);
        }
        content(p, names, opened);
        names.pop();
    }
    m.complete(p, ELEMENT);
}

/// A start tag; true if content follows.
fn start_tag(p: &mut Parser<'_>) -> bool {
    let m = p.start();
    let opened = p.position();
    p.bump();
    p.eat(XML_NAME);
    attributes(p);
    let has_content = p.at(R_ANGLE);
    close_tag(p, p.range(opened), None);
    m.complete(p, START_TAG);
    has_content
}

fn attributes(p: &mut Parser<'_>) {
    let mut seen = Vec::new();
    loop {
        match p.current() {
            XML_NAME => {
                seen.push((p.text(), p.position()));
                attribute(p);
            }
            XML_EQ | XML_STRING => {
                let name = p.text().to_owned();
                p.structure_error(SyntaxErrorKind::MalformedAttribute { name }, p.range(p.position()), None);
                p.bump();
            }
            ERROR_TOKEN => p.bump(),
            _ => break,
        }
    }
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

fn attribute(p: &mut Parser<'_>) {
    let m = p.start();
    let (name, at) = (p.text(), p.position());
    p.bump();
    if !(p.eat(XML_EQ) && p.eat(XML_STRING)) {
        let kind = SyntaxErrorKind::MalformedAttribute { name: name.to_owned() };
        p.structure_error(kind, p.range(at), None);
    }
    m.complete(p, ATTRIBUTE);
}

/// What stands between the tags of the element that opened at `opened`, and its end tag.
fn content<'i>(p: &mut Parser<'i>, names: &mut Vec<&'i str>, opened: usize) {
    loop {
        match p.current() {
            L_ANGLE => element(p, names),
            L_ANGLE_SLASH => match end_tag_target(p, names) {
                EndTag::Mine => return end_tag(p, opened),
                EndTag::Outer => return unclosed(p, names, opened),
                EndTag::Nobody => unmatched_end_tag(p),
            },
            EOF => {
                // One truncated file is one fault: the innermost element has the message.
                if !p.end_told() {
                    unclosed(p, names, opened);
                    p.tell_end();
                }
                return;
            }
            _ => p.bump(),
        }
    }
}

enum EndTag {
    Mine,
    Outer,
    Nobody,
}

fn end_tag_target(p: &Parser<'_>, names: &[&str]) -> EndTag {
    let name = if p.nth(1) == XML_NAME { p.text_at(p.position() + 1) } else { "" };
    if names.last() == Some(&name) {
        EndTag::Mine
    } else if names.contains(&name) {
        EndTag::Outer
    } else {
        EndTag::Nobody
    }
}

fn unclosed(p: &mut Parser<'_>, names: &[&str], opened: usize) {
    let name = names.last().copied().unwrap_or("").to_owned();
    let opener = p.range(opened).cover(p.range(opened + 1));
    p.structure_error(SyntaxErrorKind::UnclosedElement { name }, opener, Some(p.here_behind()));
}

fn end_tag(p: &mut Parser<'_>, opened: usize) {
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

/// The `>` of a tag, or the message at `place` that it is missing.
fn close_tag(p: &mut Parser<'_>, place: TextRange, opened: Option<TextRange>) {
    if p.eat(R_ANGLE) || p.eat(SLASH_R_ANGLE) {
        return;
    }
    if !p.at(EOF) || !p.end_told() {
        p.structure_error(SyntaxErrorKind::Unterminated(XmlPart::Tag), place, opened);
    }
    if p.at(EOF) {
        p.tell_end();
    }
}

/// An end tag that closes nothing.
fn unmatched_end_tag(p: &mut Parser<'_>) {
    let m = p.start();
    let opened = p.position();
    p.bump();
    let name = if p.at(XML_NAME) { p.text().to_owned() } else { String::new() };
    p.structure_error(SyntaxErrorKind::UnmatchedEndTag { name }, p.range(opened).cover(p.range(p.position())), None);
    finish_end_tag(p, m, opened);
}
