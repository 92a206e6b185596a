//! Construction of the tree from events and tokens.

use std::sync::Arc;

use super::ParseEvent;
use crate::kind::SyntaxKind;
use crate::lexer::Token;
use crate::tree::{SourceTree, TreeEntry, count};

/// Builds the tree of `text`. Trivia is placed between nodes, except that a `CODE` node contains all trivia inside the
/// code.
pub(crate) fn build_tree(text: Arc<str>, tokens: &[Token], mut events: Vec<ParseEvent>) -> SourceTree {
    let nodes = events.iter().filter(|event| **event == ParseEvent::Finish).count();
    let mut sink = Sink::new(tokens, nodes);
    let mut opening = Vec::new();
    for index in 0..events.len() {
        match events.get(index).copied() {
            Some(ParseEvent::Start { kind, parent: 0 }) => sink.open(kind),
            Some(ParseEvent::Start { kind, parent }) => {
                collect_parents(&mut events, index, kind, parent, &mut opening);
                opening.drain(..).rev().for_each(|kind| sink.open(kind));
            }
            Some(ParseEvent::Finish) => sink.close(),
            Some(ParseEvent::Token) => sink.token(),
            Some(ParseEvent::Abandoned) | None => {}
        }
    }
    SourceTree::new(text, sink.entries)
}

/// Collects the kinds of the nodes that start at `index`, innermost first. Their own `Start` events are consumed.
fn collect_parents(events: &mut [ParseEvent], index: usize, kind: SyntaxKind, parent: u32, out: &mut Vec<SyntaxKind>) {
    out.push(kind);
    let (mut at, mut distance) = (index, parent);
    while distance != 0 {
        at += distance as usize;
        let Some(event) = events.get_mut(at) else { return };
        let ParseEvent::Start { kind, parent } = std::mem::replace(event, ParseEvent::Abandoned) else { return };
        out.push(kind);
        distance = parent;
    }
}

/// Typical maximum nesting of nodes.
const DEPTH: usize = 32;

struct Sink<'t> {
    /// Remaining tokens.
    tokens: &'t [Token],
    /// Offset of the next token.
    start: u32,
    entries: Vec<TreeEntry>,
    /// Open nodes, innermost last.
    open: Vec<OpenNode>,
}

/// A node that has not ended.
struct OpenNode {
    /// Index of the node's entry.
    index: usize,
    /// Start offset in the text.
    start: u32,
    is_code: bool,
}

impl<'t> Sink<'t> {
    fn new(tokens: &'t [Token], nodes: usize) -> Self {
        let entries = Vec::with_capacity(tokens.len() + nodes);
        Self { tokens, start: 0, entries, open: Vec::with_capacity(DEPTH) }
    }

    fn open(&mut self, kind: SyntaxKind) {
        let is_code = kind == SyntaxKind::CODE;
        if !self.open.is_empty() && !is_code {
            self.trivia();
        }
        self.open.push(OpenNode { index: self.entries.len(), start: self.start, is_code });
        self.entries.push(TreeEntry { kind, len: 0, size: 0 });
    }

    fn close(&mut self) {
        let Some(node) = self.open.pop() else { return };
        if self.open.is_empty() || node.is_code {
            self.trivia();
        }
        let size = count(self.entries.len() - node.index - 1);
        if let Some(entry) = self.entries.get_mut(node.index) {
            entry.len = self.start - node.start;
            entry.size = size;
        }
    }

    /// Adds the following trivia.
    fn trivia(&mut self) {
        while let Some((token, rest)) = self.tokens.split_first()
            && token.kind.is_trivia()
        {
            self.take(*token, rest);
        }
    }

    /// Adds the next non-trivia token and the trivia before it.
    fn token(&mut self) {
        while let Some((token, rest)) = self.tokens.split_first() {
            self.take(*token, rest);
            if !token.kind.is_trivia() {
                return;
            }
        }
    }

    fn take(&mut self, token: Token, rest: &'t [Token]) {
        self.entries.push(TreeEntry { kind: token.kind, len: token.end - self.start, size: 0 });
        self.start = token.end;
        self.tokens = rest;
    }
}
