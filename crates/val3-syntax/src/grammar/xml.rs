//! Elements and their content.

use super::program::code;
use super::tags::{end_tag, start_tag, unmatched_end_tag};
use crate::error::SyntaxErrorKind;
use crate::kind::SyntaxKind::*;
use crate::parser::Parser;

/// Elements of program, data and project files that contain elements but no text.
const HOLDS_ELEMENTS: &[&str] = &[
    "Programs",
    "Program",
    "Parameters",
    "Locals",
    "Database",
    "Datas",
    "Data",
    "Value",
    "Field",
    "Project",
    "Libraries",
    "Types",
    "programList",
    "program",
    "paramSection",
    "localSection",
    "dataList",
    "project",
    "programSection",
    "dataSection",
    "aliasSection",
];

/// Parses a file: one root element. Other content outside of it is reported once.
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
            L_ANGLE_SLASH => unmatched_end_tag(p, None),
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
    if roots == 0 && strays == 0 && !p.is_end_reported() {
        p.structure_error(SyntaxErrorKind::RootElement, p.range(p.position()), None);
    }
    m.complete(p, XML_FILE);
}

/// Parses an element; `names` are the names of the enclosing elements.
fn element<'i>(p: &mut Parser<'i>, names: &mut Vec<&'i str>) {
    p.start_statement();
    if p.nested_block(|p| element_inner(p, names)).is_none() {
        p.mark_end_reported();
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
    if start_tag(p, names.is_empty()) {
        names.push(name);
        if matches!(name, "Code" | "code") {
            code(p, opened);
        }
        content(p, names, opened);
        names.pop();
    }
    m.complete(p, ELEMENT);
}

/// Parses the content and the end tag of the element at `opened`.
fn content<'i>(p: &mut Parser<'i>, names: &mut Vec<&'i str>, opened: usize) {
    let mut told = names.last().is_none_or(|name| !HOLDS_ELEMENTS.contains(name));
    loop {
        match p.current() {
            L_ANGLE => element(p, names),
            XML_TEXT if !told => {
                told = true;
                p.structure_error(SyntaxErrorKind::UnexpectedText, p.range(p.position()), None);
                p.bump();
            }
            L_ANGLE_SLASH => match end_tag_target(p, names) {
                EndTag::Mine => return end_tag(p, opened),
                EndTag::Outer => return unclosed(p, names, opened),
                EndTag::Misspelt => return unmatched_end_tag(p, Some(opened)),
                EndTag::Nobody => unmatched_end_tag(p, None),
            },
            EOF => {
                // A truncated file is one fault: only the innermost element is reported.
                if !p.is_end_reported() {
                    unclosed(p, names, opened);
                    p.mark_end_reported();
                }
                return;
            }
            _ => p.bump(),
        }
    }
}

/// The element that an end tag closes.
enum EndTag {
    Mine,
    Outer,
    /// No open element has this name, but the name resembles the innermost element's, or the innermost element needs an
    /// end tag here.
    Misspelt,
    Nobody,
}

fn end_tag_target(p: &Parser<'_>, names: &[&str]) -> EndTag {
    let name = end_tag_name(p, 0);
    if names.last().copied() == name {
        EndTag::Mine
    } else if name.is_some_and(|name| names.contains(&name)) {
        EndTag::Outer
    } else if p.nth(2) == R_ANGLE
        && !continues_after(p, names)
        && (is_alike(name, names.last()) || is_end_of_outer(p, names))
    {
        EndTag::Misspelt
    } else {
        EndTag::Nobody
    }
}

/// Whether the end tag is superfluous: after it follows the innermost element's real end tag, or a sibling of the
/// element that it would close.
fn continues_after(p: &Parser<'_>, names: &[&str]) -> bool {
    let closed = end_tag_name(p, 0);
    let next_opened = (p.nth(3) == L_ANGLE && p.nth(4) == XML_NAME).then(|| p.text_at(p.position() + 4));
    end_tag_name(p, 3) == names.last().copied() || next_opened == closed
}

/// Whether at least the first half of the names is equal, in any letter case.
fn is_alike(name: Option<&str>, other: Option<&&str>) -> bool {
    let (Some(name), Some(other)) = (name, other) else { return false };
    let same = name.bytes().zip(other.bytes()).take_while(|(a, b)| a.eq_ignore_ascii_case(b)).count();
    2 * same >= name.len().max(other.len())
}

/// Whether the end tag of the second innermost element follows this one; for the root, whether the text ends.
fn is_end_of_outer(p: &Parser<'_>, names: &[&str]) -> bool {
    match names {
        [.., outer, _] => end_tag_name(p, 3) == Some(outer),
        _ => p.nth(3) == EOF,
    }
}

/// Returns the name in the end tag `n` tokens ahead.
fn end_tag_name<'i>(p: &Parser<'i>, n: usize) -> Option<&'i str> {
    (p.nth(n) == L_ANGLE_SLASH && p.nth(n + 1) == XML_NAME).then(|| p.text_at(p.position() + n + 1))
}

fn unclosed(p: &mut Parser<'_>, names: &[&str], opened: usize) {
    let name = names.last().copied().unwrap_or("").to_owned();
    let opener = p.range(opened).cover(p.range(opened + 1));
    p.structure_error(SyntaxErrorKind::UnclosedElement { name }, opener, Some(p.range_after()));
}
