//! Green tokens and small nodes that repeat are built once and shared.
//!
//! In the tables a newcomer takes the place of what was there: sharing saves most of the memory, and a look-up takes
//! the same time in a tree of any size and shape.

use std::hash::Hasher;

use rowan::{GreenNode, GreenNodeData, GreenToken, GreenTokenData, NodeOrToken};
use rustc_hash::FxHasher;

use crate::kind::SyntaxKind;

/// A node or token of the tree without positions.
pub(super) type Element = NodeOrToken<GreenNode, GreenToken>;

/// What was built lately.
pub(super) struct Sharing {
    /// As long as `nodes`: a power of two.
    tokens: Vec<Option<GreenToken>>,
    nodes: Vec<Option<GreenNode>>,
}

/// The least and the most entries of a table.
const TABLE: (usize, usize) = (64, 4096);
/// Longer tokens are comments and texts, which seldom repeat.
const LONGEST_TOKEN: usize = 16;
/// Nodes with more children do not repeat.
const MOST_CHILDREN: usize = 3;

impl Sharing {
    /// Tables for a text of so many tokens.
    pub(super) fn new(tokens: usize) -> Self {
        let entries = (tokens / 8).next_power_of_two().clamp(TABLE.0, TABLE.1);
        Self { tokens: vec![None; entries], nodes: vec![None; entries] }
    }

    pub(super) fn token(&mut self, kind: SyntaxKind, text: &str) -> GreenToken {
        if text.len() > LONGEST_TOKEN {
            return GreenToken::new(kind.into(), text);
        }
        let slot = token_hash(kind, text) & (self.tokens.len() - 1);
        let Some(entry) = self.tokens.get_mut(slot) else {
            return GreenToken::new(kind.into(), text);
        };
        match entry {
            Some(token) if token.kind() == kind.into() && token.text() == text => token.clone(),
            _ => entry.insert(GreenToken::new(kind.into(), text)).clone(),
        }
    }

    /// A node with `children`, which leave their place.
    pub(super) fn node(&mut self, kind: SyntaxKind, children: std::vec::Drain<'_, Element>) -> GreenNode {
        if children.len() > MOST_CHILDREN {
            return GreenNode::new(kind.into(), children);
        }
        let slot = node_hash(kind, children.as_slice()) & (self.nodes.len() - 1);
        let Some(entry) = self.nodes.get_mut(slot) else {
            return GreenNode::new(kind.into(), children);
        };
        match entry {
            Some(node) if is_same(node, kind, children.as_slice()) => node.clone(),
            _ => entry.insert(GreenNode::new(kind.into(), children)).clone(),
        }
    }
}

fn token_hash(kind: SyntaxKind, text: &str) -> usize {
    let mut hasher = FxHasher::default();
    hasher.write(text.as_bytes());
    hasher.write_u16(kind as u16);
    hasher.finish() as usize
}

/// Equal children are shared, so their addresses tell one node from another.
fn node_hash(kind: SyntaxKind, children: &[Element]) -> usize {
    let mut hasher = FxHasher::default();
    hasher.write_u16(kind as u16);
    for child in children {
        hasher.write_usize(address(child));
    }
    hasher.finish() as usize
}

fn is_same(node: &GreenNode, kind: SyntaxKind, children: &[Element]) -> bool {
    node.kind() == kind.into()
        && node.children().len() == children.len()
        && node.children().zip(children).all(|(old, new)| match (old, new) {
            (NodeOrToken::Node(old), NodeOrToken::Node(new)) => std::ptr::eq(old, &**new),
            (NodeOrToken::Token(old), NodeOrToken::Token(new)) => std::ptr::eq(old, &**new),
            _ => false,
        })
}

fn address(element: &Element) -> usize {
    match element {
        NodeOrToken::Node(node) => std::ptr::from_ref::<GreenNodeData>(node).addr(),
        NodeOrToken::Token(token) => std::ptr::from_ref::<GreenTokenData>(token).addr(),
    }
}
