//! Parsing again after an edit of lines without blocks: those lines alone.
//!
//! A statement ends with its line, and only the keywords of blocks mean something to other lines. So lines without
//! them, read between a `begin` and an `end` of their own, give the tree that they give in their program.

use std::ops::Range;

use memchr::memmem;
use rowan::{GreenNode, GreenToken, NodeOrToken, TextRange, TextSize};

use super::reparse::Change;
use super::{Parse, parse_within};
use crate::kind::{SyntaxKind, SyntaxNode};

type Element = NodeOrToken<GreenNode, GreenToken>;

impl Parse {
    /// The parse of `new_text`, where `self` is that of `text`; `None` where other lines have to be read again.
    pub(super) fn reparse_lines(&self, text: &str, new_text: &str, change: Change) -> Option<Parse> {
        if !self.has_line_faults_only() {
            return None;
        }
        let (run, lines) = runs_around(&self.root(), change.range).find_map(|run| {
            let lines = run.lines_around(change.range)?;
            Some((run, lines))
        })?;
        let old = run.range_of(&lines);
        if run.elements.get(lines.clone())?.iter().any(concerns_others) {
            return None;
        }
        let new = TextRange::new(old.start(), change.moved(old.end()));
        let (head, tail) = around(text, &run.parent, old.start());
        let code = new_text.get(Range::<usize>::from(new)).filter(|code| !leaves_stretch(code, tail))?;
        let read = parse_within(&[head, code, tail].concat(), depth(&run.parent));
        let inside = read.sole_run()?;
        let is_whole = inside.start == TextSize::of(head) && inside.len() == new.len();
        let ends_line = inside.elements.last().is_some_and(is_line_end) && starts_as_before(new_text, new.end());
        if !is_whole || !ends_line || !read.has_line_faults_only() || inside.elements.iter().any(concerns_others) {
            return None;
        }
        let place = |at: TextSize| at - TextSize::of(head) + old.start();
        let odd_keywords = self.spliced_keywords(old, change, &read, place).into();
        let errors = self.spliced_errors(old, change, &read, place).into();
        Some(Parse { green: run.with(lines, inside.elements)?, errors, odd_keywords })
    }

    fn has_line_faults_only(&self) -> bool {
        self.errors.iter().all(|error| error.kind.is_local_to_line())
    }

    /// The only run of statements of a text.
    fn sole_run(&self) -> Option<Run> {
        let root = self.root();
        let code = root.first_child()?.children().find(|node| node.kind() == SyntaxKind::CODE)?;
        let is_sole = root.first_child()?.text_range() == root.text_range();
        code.children().find_map(Run::new).filter(|_| is_sole)
    }
}

/// What stands before and behind lines of the same stretch of code, so that they are a program.
fn around(text: &str, parent: &SyntaxNode, at: TextSize) -> (&'static str, &'static str) {
    let code = parent.ancestors().find(|node| node.kind() == SyntaxKind::CODE);
    let start = code.map_or(at, |code| code.text_range().start());
    let before = text.get(Range::<usize>::from(TextRange::new(start, at))).unwrap_or("").as_bytes();
    match memmem::rfind(before, b"<![CDATA[") > memmem::rfind(before, b"]]>") {
        true => ("<Code><![CDATA[begin", "end]]></Code>"),
        false => ("<code>begin", "end</code>"),
    }
}

/// The lines hold what may be the end of their stretch of code.
fn leaves_stretch(code: &str, tail: &str) -> bool {
    code.contains("]]>") || tail.starts_with("end<") && code.contains('<')
}

/// The first token of the line at `at` is what it was, however the line is indented: it goes on with no blank, and
/// starts no mark of a merge conflict.
fn starts_as_before(text: &str, at: TextSize) -> bool {
    let next = text.as_bytes().get(usize::from(at));
    next.is_some_and(|byte| !byte.is_ascii_whitespace() && !b"<>|=".contains(byte))
}

/// The levels around a node, or more.
fn depth(node: &SyntaxNode) -> u32 {
    u32::try_from(node.ancestors().count()).unwrap_or(u32::MAX)
}

/// A block of statements with the trivia around it.
struct Run {
    /// The node that holds both.
    parent: SyntaxNode,
    /// The indexes of the block and the trivia around it in `parent`.
    indexes: Range<usize>,
    /// Trivia, the statements of the block with trivia between them, and trivia.
    elements: Vec<Element>,
    start: TextSize,
}

/// The runs that an edit may lie in, inner ones first.
fn runs_around(root: &SyntaxNode, range: TextRange) -> impl Iterator<Item = Run> {
    let covering = match root.covering_element(range) {
        NodeOrToken::Node(node) => Some(node),
        NodeOrToken::Token(token) => token.parent(),
    };
    let nodes = covering.into_iter().flat_map(|node| node.ancestors().collect::<Vec<_>>());
    nodes.filter(|node| node.kind() != SyntaxKind::BLOCK).flat_map(|node| node.children()).filter_map(Run::new)
}

impl Run {
    fn new(block: SyntaxNode) -> Option<Self> {
        let parent = block.parent().filter(|_| block.kind() == SyntaxKind::BLOCK)?;
        let siblings: Vec<Element> = owned(&parent);
        let (before, behind) = (siblings.get(..block.index())?, siblings.get(block.index() + 1..)?);
        let is_trivia = |element: &&Element| is_trivia(element);
        let first = block.index() - before.iter().rev().take_while(is_trivia).count();
        let last = block.index() + 1 + behind.iter().take_while(is_trivia).count();
        let (before, behind) = (siblings.get(first..block.index())?, siblings.get(block.index() + 1..last)?);
        let start = block.text_range().start() - before.iter().map(len).sum::<TextSize>();
        let elements = [before, &owned(&block), behind].concat();
        Some(Self { parent, indexes: first..last, elements, start })
    }

    fn len(&self) -> TextSize {
        self.elements.iter().map(len).sum()
    }

    /// The elements from the line end before an edit to the one behind it, or in which it ends.
    fn lines_around(&self, edit: TextRange) -> Option<Range<usize>> {
        let (mut first, mut at) = (None, self.start);
        for (index, element) in self.elements.iter().enumerate() {
            match first {
                Some(first) if is_line_end(element) && at + len(element) >= edit.end() => {
                    return Some(first..index + 1);
                }
                _ if is_line_end(element) && at < edit.start() => first = Some(index),
                _ => {}
            }
            at += len(element);
        }
        None
    }

    fn range_of(&self, elements: &Range<usize>) -> TextRange {
        let len_of = |range: Range<usize>| self.elements.get(range).unwrap_or(&[]).iter().map(len).sum::<TextSize>();
        TextRange::at(self.start + len_of(0..elements.start), len_of(elements.clone()))
    }

    /// The tree of the whole file with other elements in the place of some.
    fn with(mut self, replaced: Range<usize>, elements: Vec<Element>) -> Option<GreenNode> {
        self.elements.splice(replaced, elements);
        let first = self.elements.iter().position(|element| !is_trivia(element)).unwrap_or(self.elements.len());
        let last = self.elements.iter().rposition(|element| !is_trivia(element)).map_or(first, |last| last + 1);
        let behind = self.elements.split_off(last);
        // Trivia at the end of a node belongs to the node around it.
        if !behind.is_empty() && self.indexes.end == self.parent.green().children().len() {
            return None;
        }
        let block = GreenNode::new(SyntaxKind::BLOCK.into(), self.elements.split_off(first));
        let new = self.elements.into_iter().chain([block.into()]).chain(behind);
        Some(self.parent.replace_with(self.parent.green().splice_children(self.indexes, new)))
    }
}

fn owned(node: &SyntaxNode) -> Vec<Element> {
    node.green().children().map(|child| child.to_owned()).collect()
}

fn len(element: &Element) -> TextSize {
    match element {
        NodeOrToken::Node(node) => node.text_len(),
        NodeOrToken::Token(token) => token.text_len(),
    }
}

fn is_trivia(element: &Element) -> bool {
    element.as_token().is_some_and(|token| SyntaxKind::from_raw(token.kind()).is_trivia())
}

fn is_line_end(element: &Element) -> bool {
    element.as_token().is_some_and(|token| token.text().starts_with(['\n', '\r']))
}

/// A keyword or mark in it says something about other lines.
fn concerns_others(element: &Element) -> bool {
    match element {
        NodeOrToken::Token(token) => is_of_blocks(SyntaxKind::from_raw(token.kind())),
        NodeOrToken::Node(node) => node.children().any(|child| concerns_others(&child.to_owned())),
    }
}

fn is_of_blocks(kind: SyntaxKind) -> bool {
    use SyntaxKind::*;
    let is_word = matches!(kind, BEGIN_KW | END_KW | IF_KW | ELSE_IF_KW | ELSE_KW | END_IF_KW | BREAK_KW | DEFAULT_KW)
        || matches!(kind, WHILE_KW | END_WHILE_KW | DO_KW | UNTIL_KW | FOR_KW | END_FOR_KW)
        || matches!(kind, SWITCH_KW | CASE_KW | END_SWITCH_KW);
    is_word || matches!(kind, XML_COMMENT | CDATA_OPEN | CDATA_CLOSE | CONFLICT_MARKER)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::parse;

    const CDATA: &str = "<a>\n<Code><![CDATA[begin\n  x=1\n  if x==1\n    put(x)\n    // two\n    y=\n  else\n  endIf\n\n  z=3\nend]]></Code>\n</a>";

    /// Whether an edit of `old` to `new` needs its own lines alone.
    fn is_local(text: &str, old: &str, new: &str) -> bool {
        let new_text = text.replacen(old, new, 1);
        let start = TextSize::try_from(text.find(old).unwrap()).unwrap();
        let change = Change { range: TextRange::at(start, TextSize::of(old)), inserted: TextSize::of(new) };
        let again = parse(text).reparse_lines(text, &new_text, change);
        assert!(again.as_ref().is_none_or(|again| *again == parse(&new_text)));
        again.is_some()
    }

    #[test]
    fn lines_without_blocks() {
        let edits = [("x=1", "x=12"), ("  x=1\n", ""), ("  x=1", "  w=2\n  x=1"), ("z=3", "z=3\n\n"), ("two", "2")];
        for (old, new) in edits.into_iter().chain([("y=", "y=f(2"), ("put(x)", "put(x)\n    Call p()"), ("(x)", "(")]) {
            assert!(is_local(CDATA, old, new), "{old} {new}");
        }
    }

    #[test]
    fn lines_that_concern_others() {
        for (old, new) in
            [("x==1", "x==2"), ("x=1", "endIf"), ("z=3", "]]>"), ("endIf", ""), ("begin", "begin "), ("z=3", "end if")]
        {
            assert!(!is_local(CDATA, old, new), "{old} {new}");
        }
    }

    #[test]
    fn escaped_code() {
        let text = "<a><code>begin\nx=1 &lt; 2\ny=2\nend</code></a>";
        assert!(is_local(text, "1 &lt;", "1 &gt;") && is_local(text, "y=2", "y=&quot;&quot;"));
        assert!(!is_local(text, "y=2", "y=1 < 2") && !is_local(text, "y=2", "</code>"));
    }
}
