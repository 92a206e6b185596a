//! Sharing of repeated green tokens and small nodes.
//!
//! A new item replaces the previous item in its table slot: this saves most of the memory, and a lookup takes constant
//! time for trees of any size and shape. Each thread has its own tables for all files, because items repeat across
//! programs. The tables keep no large item alive.

use std::cell::RefCell;
use std::hash::Hasher;

use rowan::{GreenNode, GreenNodeData, GreenToken, GreenTokenData, NodeOrToken};
use rustc_hash::FxHasher;

use crate::kind::SyntaxKind;

/// A node or token of the green tree, without position.
pub(super) type GreenElement = NodeOrToken<GreenNode, GreenToken>;

/// Recently built tokens and nodes.
pub(super) struct Sharing {
    /// Tokens with one byte, by their byte. About half of all tokens have one byte.
    bytes: Box<[Option<GreenToken>]>,
    tokens: Box<[Option<GreenToken>]>,
    nodes: Box<[Option<GreenNode>]>,
}

thread_local! {
    static SHARING: RefCell<Sharing> = RefCell::new(Sharing::new());
}

/// Table size, a power of two.
const TABLE: usize = 1 << 13;
/// Maximum length in bytes of shared tokens. Longer tokens are comments and texts, which rarely repeat.
const LONGEST_TOKEN: usize = 32;
/// Maximum number of children in shared nodes. Nodes with more children rarely repeat.
const MOST_CHILDREN: usize = 3;
/// Maximum text length in bytes of shared nodes. Longer nodes rarely repeat.
const LONGEST_NODE: u32 = 64;

/// Runs `build` with the tables of this thread.
pub(super) fn with_sharing<T>(build: impl FnOnce(&mut Sharing) -> T) -> T {
    SHARING.with_borrow_mut(build)
}

impl Sharing {
    fn new() -> Self {
        let bytes = vec![None; 1 << 8].into();
        Self { bytes, tokens: vec![None; TABLE].into(), nodes: vec![None; TABLE].into() }
    }

    pub(super) fn token(&mut self, kind: SyntaxKind, text: &str) -> GreenToken {
        if text.len() > LONGEST_TOKEN {
            return GreenToken::new(kind.into(), text);
        }
        if let [byte] = text.as_bytes()
            && let Some(entry) = self.bytes.get_mut(usize::from(*byte))
        {
            return match entry {
                Some(token) if token.kind() == kind.into() => token.clone(),
                _ => entry.insert(GreenToken::new(kind.into(), text)).clone(),
            };
        }
        let slot = token_slot(kind, text) % TABLE;
        let Some(entry) = self.tokens.get_mut(slot) else {
            return GreenToken::new(kind.into(), text);
        };
        match entry {
            Some(token) if token.kind() == kind.into() && token.text() == text => token.clone(),
            _ => entry.insert(GreenToken::new(kind.into(), text)).clone(),
        }
    }

    /// Returns a node with `children`, which are moved into it.
    pub(super) fn node(&mut self, kind: SyntaxKind, children: std::vec::Drain<'_, GreenElement>) -> GreenNode {
        if children.len() > MOST_CHILDREN || text_len(children.as_slice()) > LONGEST_NODE {
            return GreenNode::new(kind.into(), children);
        }
        let slot = node_hash(kind, children.as_slice()) % TABLE;
        let Some(entry) = self.nodes.get_mut(slot) else {
            return GreenNode::new(kind.into(), children);
        };
        match entry {
            Some(node) if is_same(node, kind, children.as_slice()) => node.clone(),
            _ => entry.insert(GreenNode::new(kind.into(), children)).clone(),
        }
    }
}

fn token_slot(kind: SyntaxKind, text: &str) -> usize {
    let mut hasher = FxHasher::default();
    hasher.write(text.as_bytes());
    hasher.write_u16(kind as u16);
    hasher.finish() as usize
}

/// Hashes a node. Equal children are shared, so their addresses identify them.
fn node_hash(kind: SyntaxKind, children: &[GreenElement]) -> usize {
    let mut hasher = FxHasher::default();
    hasher.write_u16(kind as u16);
    for child in children {
        hasher.write_usize(address(child));
    }
    hasher.finish() as usize
}

fn is_same(node: &GreenNode, kind: SyntaxKind, children: &[GreenElement]) -> bool {
    node.kind() == kind.into()
        && node.children().len() == children.len()
        && node.children().zip(children).all(|(old, new)| match (old, new) {
            (NodeOrToken::Node(old), NodeOrToken::Node(new)) => std::ptr::eq(old, &**new),
            (NodeOrToken::Token(old), NodeOrToken::Token(new)) => std::ptr::eq(old, &**new),
            _ => false,
        })
}

fn text_len(children: &[GreenElement]) -> u32 {
    let lengths = children.iter().map(|child| match child {
        NodeOrToken::Node(node) => u32::from(node.text_len()),
        NodeOrToken::Token(token) => u32::from(token.text_len()),
    });
    lengths.sum()
}

fn address(element: &GreenElement) -> usize {
    match element {
        NodeOrToken::Node(node) => std::ptr::from_ref::<GreenNodeData>(node).addr(),
        NodeOrToken::Token(token) => std::ptr::from_ref::<GreenTokenData>(token).addr(),
    }
}
