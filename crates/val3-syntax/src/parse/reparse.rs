//! Parsing again after an edit: only its lines ([`lines`](super::lines)) or the innermost element around it, where that
//! is safe.
//!
//! An element's tree depends on nothing outside of it as long as its own XML is in order; then the element can be
//! parsed alone and put in the place of the old one. Everything else is parsed anew as a whole.

use std::ops::Range;

use rowan::{GreenNode, NodeOrToken, TextRange, TextSize};

use super::{Parse, parse, parse_within};
use crate::error::SyntaxError;
use crate::kind::{SyntaxKind, SyntaxNode};

/// A replacement of a range of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edit {
    /// The range of the old text.
    pub range: TextRange,
    /// What takes its place.
    pub insert: String,
}

impl Edit {
    /// The text after the edit. A range outside the text is cut to it, one inside of a character starts before it.
    pub fn apply(&self, text: &str) -> String {
        let Range { start, end } = self.range_in(text).into();
        let (before, after) = (text.get(..start).unwrap_or(""), text.get(end..).unwrap_or(""));
        [before, &self.insert, after].concat()
    }

    /// The range that is replaced in `text`.
    fn range_in(&self, text: &str) -> TextRange {
        let floor = |at: TextSize| text.floor_char_boundary(usize::from(at).min(text.len()));
        crate::lexer::range(floor(self.range.start()), floor(self.range.end()))
    }
}

/// An edit that fits its text.
#[derive(Clone, Copy)]
pub(super) struct Change {
    pub(super) range: TextRange,
    pub(super) inserted: TextSize,
}

impl Change {
    /// What lies between the equal beginnings and the equal ends of two texts.
    fn between(text: &str, new_text: &str) -> Self {
        let same = |(a, b): &(u8, u8)| a == b;
        let start = text.bytes().zip(new_text.bytes()).take_while(same).count();
        let start = text.floor_char_boundary(start);
        let (rest, new_rest) = (text.get(start..).unwrap_or(""), new_text.get(start..).unwrap_or(""));
        let end = rest.bytes().rev().zip(new_rest.bytes().rev()).take_while(same).count();
        // The equal ends begin with a whole character, which is then one of both texts.
        let end = text.len() - text.ceil_char_boundary(text.len() - end);
        let inserted = crate::lexer::range(start, new_text.len() - end).len();
        Self { range: crate::lexer::range(start, text.len() - end), inserted }
    }

    /// Where a place behind the edit is afterwards.
    pub(super) fn moved(self, at: TextSize) -> TextSize {
        at - self.range.len() + self.inserted
    }
}

impl Parse {
    /// The parse of `text` after `edit`, where `self` is the parse of `text`: equal to `parse(&edit.apply(text))`.
    pub fn reparse(&self, text: &str, edit: &Edit) -> Parse {
        let new_text = edit.apply(text);
        let change = Change { range: edit.range_in(text), inserted: TextSize::of(&edit.insert) };
        self.reparse_change(text, &new_text, change)
    }

    /// The parse of `new_text`, where `self` is the parse of `text`: equal to `parse(new_text)`, and fast where both
    /// texts are alike but for one place.
    pub fn reparse_as(&self, text: &str, new_text: &str) -> Parse {
        self.reparse_change(text, new_text, Change::between(text, new_text))
    }

    fn reparse_change(&self, text: &str, new_text: &str, change: Change) -> Parse {
        let lines = self.reparse_lines(text, new_text, change);
        let again = lines.or_else(|| self.reparse_element(text, new_text, change));
        again.unwrap_or_else(|| parse(new_text))
    }

    fn reparse_element(&self, text: &str, new_text: &str, change: Change) -> Option<Parse> {
        // A broken file around the element may change what it means.
        if !are_local(&self.errors) {
            return None;
        }
        let element = enclosing_element(&self.root(), change.range)?;
        let old = element.text_range();
        let new = TextRange::new(old.start(), change.moved(old.end()));
        let fragment = parse_within(new_text.get(Range::<usize>::from(new))?, depth(&element));
        let green = sole_element(&fragment).filter(|_| are_local(&fragment.errors))?;
        let place = |at| at + old.start();
        let errors = self.spliced_errors(old, change, &fragment, place);
        // The faults of one line are judged together, also across the edge of an element.
        if reach_edge(text, &self.errors, old) || reach_edge(new_text, &errors, new) {
            return None;
        }
        let odd_keywords = self.spliced_keywords(old, change, &fragment, place).into();
        Some(Parse { green: element.replace_with(green), errors: errors.into(), odd_keywords })
    }

    /// The old errors outside of `old`, moved by the edit, and those of the fragment; `place` tells where it stands.
    pub(super) fn spliced_errors(
        &self,
        old: TextRange,
        change: Change,
        fragment: &Parse,
        place: impl Fn(TextSize) -> TextSize,
    ) -> Vec<SyntaxError> {
        let before = self.errors.iter().filter(|error| error.range.end() <= old.start()).cloned();
        let inside = fragment.errors.iter().map(|error| shifted(error, &place));
        let behind = self.errors.iter().filter(|error| error.range.start() >= old.end());
        // What it has to do with may stand before the edit.
        let by = |at| if at >= old.end() { change.moved(at) } else { at };
        before.chain(inside).chain(behind.map(|error| shifted(error, by))).collect()
    }

    /// As [`spliced_errors`](Self::spliced_errors), of the keywords in an unusual letter case.
    pub(super) fn spliced_keywords(
        &self,
        old: TextRange,
        change: Change,
        fragment: &Parse,
        place: impl Fn(TextSize) -> TextSize,
    ) -> Vec<TextRange> {
        let before = self.odd_keywords.iter().filter(|range| range.end() <= old.start()).copied();
        let inside = fragment.odd_keywords.iter().map(|range| moved(*range, &place));
        let behind = self.odd_keywords.iter().filter(|range| range.start() >= old.end());
        before.chain(inside).chain(behind.map(|range| moved(*range, |at| change.moved(at)))).collect()
    }
}

/// All of them are faults of code, which leave the XML around it as it is.
fn are_local(errors: &[SyntaxError]) -> bool {
    errors.iter().all(|error| error.kind.is_local_to_code())
}

/// The innermost element that holds the edit between its first and its last character. The root is none: to parse it
/// is to parse the whole.
fn enclosing_element(root: &SyntaxNode, range: TextRange) -> Option<SyntaxNode> {
    let covering = match root.covering_element(range) {
        NodeOrToken::Node(node) => node,
        NodeOrToken::Token(token) => token.parent()?,
    };
    let element = covering.ancestors().find(|node| {
        let own = node.text_range();
        node.kind() == SyntaxKind::ELEMENT && own.start() < range.start() && range.end() < own.end()
    })?;
    let is_nested = element.parent().is_some_and(|parent| parent.kind() == SyntaxKind::ELEMENT);
    (is_nested && is_closed(&element)).then_some(element)
}

/// How many elements stand around `element`.
fn depth(element: &SyntaxNode) -> u32 {
    let around = element.ancestors().skip(1).filter(|node| node.kind() == SyntaxKind::ELEMENT).count();
    u32::try_from(around).unwrap_or(u32::MAX)
}

fn is_closed(element: &SyntaxNode) -> bool {
    element.last_child().is_some_and(|child| child.kind() == SyntaxKind::END_TAG)
}

/// The element that is all of a fragment.
fn sole_element(fragment: &Parse) -> Option<GreenNode> {
    let root = fragment.root();
    let element = root.first_child().filter(|child| child.kind() == SyntaxKind::ELEMENT)?;
    let whole = element.text_range() == root.text_range();
    (whole && is_closed(&element) && has_own_tags_only(&element)).then(|| element.green().into_owned())
}

/// No tag in it may belong to an element around it. A fault of the lexer on its line would hide that this one is too many.
fn has_own_tags_only(element: &SyntaxNode) -> bool {
    let is_own = |child: SyntaxNode| match child.kind() {
        SyntaxKind::ERROR => false,
        SyntaxKind::END_TAG => element.last_child().is_some_and(|last| last == child),
        SyntaxKind::ELEMENT => has_own_tags_only(&child),
        _ => true,
    };
    element.children().all(is_own)
}

/// A fault stands on the line where `element` starts or ends.
fn reach_edge(text: &str, errors: &[SyntaxError], element: TextRange) -> bool {
    let (first, last) = (line_around(text, element.start()), line_around(text, element.end()));
    errors.iter().any(|error| {
        let at = usize::from(error.range.start());
        (first.start..=first.end).contains(&at) || (last.start..=last.end).contains(&at)
    })
}

fn line_around(text: &str, at: TextSize) -> Range<usize> {
    let (before, behind) = text.split_at_checked(at.into()).unwrap_or((text, ""));
    let ends = ['\n', '\r'];
    let start = before.rfind(ends).map_or(0, |end| end + 1);
    start..before.len() + behind.find(ends).unwrap_or(behind.len())
}

fn shifted(error: &SyntaxError, by: impl Fn(TextSize) -> TextSize) -> SyntaxError {
    let related = error.related.map(|range| moved(range, &by));
    SyntaxError { kind: error.kind.clone(), range: moved(error.range, &by), related }
}

fn moved(range: TextRange, by: impl Fn(TextSize) -> TextSize) -> TextRange {
    TextRange::new(by(range.start()), by(range.end()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "<a>\n<b c=\"1\"/>\n<Code><![CDATA[begin\n  x=1\nend]]></Code>\n</a>";

    /// What an edit of `old` to `new` gives if the element alone is parsed again.
    fn alone(old: &str, new: &str) -> Option<Parse> {
        let start = TextSize::try_from(TEXT.find(old).unwrap()).unwrap();
        let change = Change { range: TextRange::at(start, TextSize::of(old)), inserted: TextSize::of(new) };
        let new_text = TEXT.replacen(old, new, 1);
        let again = parse(TEXT).reparse_element(TEXT, &new_text, change);
        assert!(again.as_ref().is_none_or(|again| *again == parse(&new_text)));
        again
    }

    #[test]
    fn code_is_parsed_alone() {
        assert!(alone("x=1", "y=(2").is_some());
        assert!(alone("begin", "").is_some());
    }

    #[test]
    fn what_touches_the_xml_is_parsed_as_a_whole() {
        assert!(alone("]]>", "").is_none());
        assert!(alone("</Code>", "</Codes>").is_none());
        assert!(alone("x=1", "<a>").is_some());
        assert!(alone("x=1", "]]></Code><Code>").is_none());
        assert!(alone("<a>", "<a >").is_none());
        assert!(alone("\n<b", " <b").is_none());
    }
}
