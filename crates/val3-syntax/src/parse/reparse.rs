//! Incremental parsing: after an edit, only the edited lines ([`lines`](super::lines)) or the innermost enclosing
//! element are parsed, if that is safe.
//!
//! The tree of a well-formed element does not depend on the surrounding text, so the element is parsed separately and
//! spliced into the old tree. After any other edit the file is parsed completely.

use std::ops::Range;
use std::sync::Arc;

use rowan::{TextRange, TextSize};

use super::{Parse, parse_shared, parse_within};
use crate::edit::{Change, TextEdit};
use crate::error::SyntaxError;
use crate::kind::SyntaxKind;
use crate::tree::{NodeRef, Splice};

impl Parse {
    /// Parses the text after `edit`. The result equals `parse(&edit.apply(text))`.
    pub fn reparse(&self, edit: &TextEdit) -> Parse {
        let text = self.tree.text();
        self.reparse_change(edit.apply(text).into(), Change::of(edit, text))
    }

    /// Parses `new_text`. The result equals `parse(new_text)`; it is fast if the texts differ in only one range.
    pub fn reparse_as(&self, new_text: Arc<str>) -> Parse {
        let change = Change::between(self.tree.text(), &new_text);
        self.reparse_change(new_text, change)
    }

    fn reparse_change(&self, new_text: Arc<str>, change: Change) -> Parse {
        if change.is_none() {
            return self.clone();
        }
        let lines = self.reparse_lines(&new_text, change);
        let again = lines.or_else(|| self.reparse_element(&new_text, change));
        let again = again.unwrap_or_else(|| parse_shared(new_text));
        again.tree.follow(&self.tree);
        again
    }

    fn reparse_element(&self, new_text: &Arc<str>, change: Change) -> Option<Parse> {
        // An error outside of the element may change the element's structure.
        if !are_local(&self.errors) {
            return None;
        }
        let path: Vec<NodeRef<'_>> = self.tree.root().path_to(change.range).collect();
        let (element, around) = enclosing_element(&path, change.range)?;
        let old = element.range();
        let new = TextRange::new(old.start(), change.moved(old.end()));
        let depth = around.iter().filter(|node| node.kind() == SyntaxKind::ELEMENT).count();
        let text = new_text.get(Range::<usize>::from(new)).filter(|text| !leaves_markup_open(text))?;
        let fragment = parse_within(text.into(), depth_of(depth));
        let inside = sole_element(&fragment).filter(|_| are_local(&fragment.errors))?;
        let place = |at| at + old.start();
        let errors = self.spliced_errors(old, change, &fragment, place);
        // Errors on the same line are merged, even across an element's boundary.
        if reach_edge(self.tree.text(), &self.errors, old) || reach_edge(new_text, &errors, new) {
            return None;
        }
        let odd_keywords = self.spliced_keywords(old, change, &fragment, place).into();
        let splice = Splice { range: element.indexes(), new: &[inside.entries()] };
        let tree = self.tree.spliced(Arc::clone(new_text), change, around, &splice);
        Some(Parse { tree: Arc::new(tree), errors: errors.into(), odd_keywords })
    }

    /// Returns the old errors outside of `old`, shifted by the edit, and the errors of the fragment at `place`.
    pub(super) fn spliced_errors(
        &self,
        old: TextRange,
        change: Change,
        fragment: &Parse,
        place: impl Fn(TextSize) -> TextSize,
    ) -> Vec<SyntaxError> {
        let before = self.errors.iter().filter(|error| error.range.end() <= old.start()).cloned();
        let inside = fragment.errors.iter().map(|error| shifted(error, &place));
        let after = self.errors.iter().filter(|error| error.range.start() >= old.end());
        // The related range may be before the edit.
        let by = |at| if at >= old.end() { change.moved(at) } else { at };
        before.chain(inside).chain(after.map(|error| shifted(error, by))).collect()
    }

    /// Like [`spliced_errors`](Self::spliced_errors), for keywords in unusual letter case.
    pub(super) fn spliced_keywords(
        &self,
        old: TextRange,
        change: Change,
        fragment: &Parse,
        place: impl Fn(TextSize) -> TextSize,
    ) -> Vec<TextRange> {
        let before = self.odd_keywords.iter().filter(|range| range.end() <= old.start()).copied();
        let inside = fragment.odd_keywords.iter().map(|range| moved(*range, &place));
        let after = self.odd_keywords.iter().filter(|range| range.start() >= old.end());
        before.chain(inside).chain(after.map(|range| moved(*range, |at| change.moved(at)))).collect()
    }
}

/// Whether the text contains markup whose end would be looked for after the text. Its error may be merged with another
/// error on its line.
fn leaves_markup_open(text: &str) -> bool {
    const MARKUP: [(&str, &str); 3] = [("<![CDATA[", "]]>"), ("<!--", "-->"), ("<?", "?>")];
    MARKUP.iter().any(|(open, close)| text.rfind(open) > text.rfind(close))
}

/// Whether all errors are errors of code, which do not affect the surrounding XML.
fn are_local(errors: &[SyntaxError]) -> bool {
    errors.iter().all(|error| error.kind.is_local_to_code())
}

/// Converts the number of enclosing nodes.
pub(super) fn depth_of(nodes: usize) -> u32 {
    u32::try_from(nodes).unwrap_or(u32::MAX)
}

/// Returns the innermost element that contains the edit between its first and last character, and the enclosing nodes.
/// The root is omitted, because parsing it means parsing the entire file.
fn enclosing_element<'p, 't>(path: &'p [NodeRef<'t>], range: TextRange) -> Option<(NodeRef<'t>, &'p [NodeRef<'t>])> {
    let index = path.iter().rposition(|node| {
        let own = node.range();
        node.kind() == SyntaxKind::ELEMENT && own.start() < range.start() && range.end() < own.end()
    })?;
    let (around, element) = (path.get(..index)?, *path.get(index)?);
    let is_nested = around.last().is_some_and(|parent| parent.kind() == SyntaxKind::ELEMENT);
    (is_nested && is_closed(element)).then_some((element, around))
}

fn is_closed(element: NodeRef<'_>) -> bool {
    nodes(element).last().is_some_and(|child| child.kind() == SyntaxKind::END_TAG)
}

fn nodes(parent: NodeRef<'_>) -> impl Iterator<Item = NodeRef<'_>> {
    parent.children().filter(|piece| piece.kind().is_node())
}

/// Returns the element if it is the entire fragment.
fn sole_element(fragment: &Parse) -> Option<NodeRef<'_>> {
    let root = fragment.tree.root();
    let element = nodes(root).next().filter(|child| child.kind() == SyntaxKind::ELEMENT)?;
    let whole = element.range() == root.range();
    (whole && is_closed(element) && has_own_tags_only(element)).then_some(element)
}

/// Whether every tag in the element belongs to it. A lexer error on the same line would hide a superfluous tag.
fn has_own_tags_only(element: NodeRef<'_>) -> bool {
    let last = nodes(element).last().map(NodeRef::index);
    nodes(element).all(|child| match child.kind() {
        SyntaxKind::ERROR => false,
        SyntaxKind::END_TAG => last == Some(child.index()),
        SyntaxKind::ELEMENT => has_own_tags_only(child),
        _ => true,
    })
}

/// Whether an error is on a line where `element` starts or ends.
fn reach_edge(text: &str, errors: &[SyntaxError], element: TextRange) -> bool {
    let (first, last) = (line_around(text, element.start()), line_around(text, element.end()));
    errors.iter().any(|error| {
        let at = usize::from(error.range.start());
        (first.start..=first.end).contains(&at) || (last.start..=last.end).contains(&at)
    })
}

fn line_around(text: &str, at: TextSize) -> Range<usize> {
    let (before, after) = text.split_at_checked(at.into()).unwrap_or((text, ""));
    let ends = ['\n', '\r'];
    let start = before.rfind(ends).map_or(0, |end| end + 1);
    start..before.len() + after.find(ends).unwrap_or(after.len())
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
    use crate::parse::parse;

    const TEXT: &str = "<a>\n<b c=\"1\"/>\n<Code><![CDATA[begin\n  x=1\nend]]></Code>\n</a>";

    /// Returns the tree after the edit from `old` to `new` if only the element is parsed.
    fn alone(old: &str, new: &str) -> Option<Parse> {
        let start = TextSize::try_from(TEXT.find(old).unwrap()).unwrap();
        let change = Change { range: TextRange::at(start, TextSize::of(old)), inserted: TextSize::of(new) };
        let new_text = TEXT.replacen(old, new, 1);
        let again = parse(TEXT).reparse_element(&new_text.as_str().into(), change);
        assert!(again.as_ref().is_none_or(|again| *again == parse(&new_text)));
        again
    }

    #[test]
    fn code_is_parsed_alone() {
        assert!(alone("x=1", "y=(2").is_some());
        assert!(alone("begin", "").is_some());
    }

    #[test]
    fn edits_of_the_xml_parse_the_whole_file() {
        assert!(alone("]]>", "").is_none());
        assert!(alone("</Code>", "</Codes>").is_none());
        assert!(alone("x=1", "<a>").is_some());
        assert!(alone("x=1", "]]></Code><Code>").is_none());
        assert!(alone("<a>", "<a >").is_none());
        assert!(alone("x=1", "x=\"<![CDATA[").is_some(), "text in a section");
        assert!(alone("\n<b", " <b").is_none());
    }
}
