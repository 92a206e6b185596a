//! Events and tokens to the tree.

use rowan::GreenNode;

use super::Event;
use super::sharing::{Element, Sharing, with_sharing};
use crate::kind::SyntaxKind;
use crate::lexer::Token;

/// Builds the tree of `text`. Trivia goes between nodes, except that a `CODE` node holds all of its own.
pub(crate) fn build_tree(text: &str, tokens: &[Token], events: Vec<Event>) -> GreenNode {
    with_sharing(|sharing| fill(Sink::new(text, tokens, sharing), events))
}

fn fill(mut sink: Sink<'_>, mut events: Vec<Event>) -> GreenNode {
    let mut opening = Vec::new();
    for index in 0..events.len() {
        match events.get(index).copied() {
            Some(Event::Start { kind, parent: 0 }) => sink.open(kind),
            Some(Event::Start { kind, parent }) => {
                collect_parents(&mut events, index, kind, parent, &mut opening);
                opening.drain(..).rev().for_each(|kind| sink.open(kind));
            }
            Some(Event::Finish) => sink.close(),
            Some(Event::Token) => sink.token(),
            Some(Event::Abandoned) | None => {}
        }
    }
    sink.finish()
}

/// The kinds of the nodes that start at `index`, innermost first. Their own `Start` events are spent.
fn collect_parents(events: &mut [Event], index: usize, kind: SyntaxKind, parent: u32, out: &mut Vec<SyntaxKind>) {
    out.push(kind);
    let (mut at, mut distance) = (index, parent);
    while distance != 0 {
        at += distance as usize;
        let Some(event) = events.get_mut(at) else { return };
        let Event::Start { kind, parent } = std::mem::replace(event, Event::Abandoned) else { return };
        out.push(kind);
        distance = parent;
    }
}

/// Nodes that are open at the same time, and their children, in most files.
const DEPTH: usize = 32;
const WIDTH: usize = 256;

struct Sink<'t> {
    text: &'t str,
    tokens: &'t [Token],
    /// Index of the next token.
    next: usize,
    /// Where it starts.
    start: usize,
    /// The nodes that are open, each with the index of its first child.
    open: Vec<(SyntaxKind, usize)>,
    /// The children of all open nodes.
    children: Vec<Element>,
    sharing: &'t mut Sharing,
}

impl<'t> Sink<'t> {
    fn new(text: &'t str, tokens: &'t [Token], sharing: &'t mut Sharing) -> Self {
        Self {
            text,
            tokens,
            next: 0,
            start: 0,
            open: Vec::with_capacity(DEPTH),
            children: Vec::with_capacity(WIDTH),
            sharing,
        }
    }

    fn open(&mut self, kind: SyntaxKind) {
        if !self.open.is_empty() && kind != SyntaxKind::CODE {
            self.trivia();
        }
        self.open.push((kind, self.children.len()));
    }

    fn close(&mut self) {
        let Some((kind, first)) = self.open.pop() else { return };
        if self.open.is_empty() || kind == SyntaxKind::CODE {
            self.trivia();
        }
        let node = self.sharing.node(kind, self.children.drain(first..));
        self.children.push(Element::Node(node));
    }

    fn trivia(&mut self) {
        while self.tokens.get(self.next).is_some_and(|token| token.kind.is_trivia()) {
            self.raw_token();
        }
    }

    fn token(&mut self) {
        self.trivia();
        self.raw_token();
    }

    fn raw_token(&mut self) {
        let Some(token) = self.tokens.get(self.next) else { return };
        let end = token.end as usize;
        let text = self.text.get(self.start..end).unwrap_or("");
        self.children.push(Element::Token(self.sharing.token(token.kind, text)));
        self.next += 1;
        self.start = end;
    }

    fn finish(mut self) -> GreenNode {
        match self.children.pop() {
            Some(Element::Node(root)) => root,
            _ => GreenNode::new(SyntaxKind::XML_FILE.into(), []),
        }
    }
}
