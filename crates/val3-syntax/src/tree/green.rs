//! The tree as a rowan tree: nodes and tokens that several trees may share.

use rowan::{GreenNode, NodeOrToken};

use super::sharing::{GreenElement, Sharing, with_sharing};
use super::{NodeRef, SourceTree};
use crate::edit::Change;
use crate::kind::SyntaxKind;
use crate::never::TextSlice;

/// Builds the rowan tree of `node`.
pub(super) fn build_green(node: NodeRef<'_>) -> GreenNode {
    let built = with_sharing(|sharing| build(sharing, node));
    built.into_node().unwrap_or_else(|| GreenNode::new(SyntaxKind::XML_FILE.into(), []))
}

/// Builds the rowan tree of `new`, sharing all unchanged parts with `green`, the rowan tree of `old`.
pub(super) fn renewed(new: &SourceTree, old: &SourceTree, green: &GreenNode) -> GreenNode {
    let change = Change::between(&old.text, &new.text);
    with_sharing(|sharing| TreeReuse { sharing, change }.node(new.root(), old.root(), green))
}

struct TreeReuse<'s> {
    sharing: &'s mut Sharing,
    change: Change,
}

impl TreeReuse<'_> {
    fn node(&mut self, new: NodeRef<'_>, old: NodeRef<'_>, green: &GreenNode) -> GreenNode {
        let (mut new_children, mut old_children): (Vec<_>, Vec<_>) =
            (new.children().collect(), old.children().collect());
        let mut children: Vec<GreenElement> = green.children().map(NodeOrToken::to_owned).collect();
        let pairs = || new_children.iter().zip(&old_children);
        let before = pairs().take_while(|(new, old)| self.is_before(**new, **old)).count();
        let pairs = || new_children.iter().skip(before).rev().zip(old_children.iter().skip(before).rev());
        let after = pairs().take_while(|(new, old)| self.is_after(**new, **old)).count();
        let changed = before..old_children.len() - after;
        let news = new_children.drain(before..new_children.len() - after);
        let is_alike = news.len() == changed.len();
        let changed_children: Vec<GreenElement> = match is_alike {
            true => {
                let olds = old_children.drain(changed.clone()).zip(children.part(changed.clone()));
                news.zip(olds).map(|(new, (old, green))| self.piece(new, old, green)).collect()
            }
            false => news.map(|new| build(self.sharing, new)).collect(),
        };
        children.splice(changed, changed_children);
        GreenNode::new(new.kind().into(), children)
    }

    fn piece(&mut self, new: NodeRef<'_>, old: NodeRef<'_>, green: &GreenElement) -> GreenElement {
        match green {
            GreenElement::Node(green) if new.kind() == old.kind() => GreenElement::Node(self.node(new, old, green)),
            _ => build(self.sharing, new),
        }
    }

    fn is_before(&self, new: NodeRef<'_>, old: NodeRef<'_>) -> bool {
        let (place, old_place) = (new.range(), old.range());
        old_place.end() <= self.change.range.start() && place == old_place && new.entries() == old.entries()
    }

    fn is_after(&self, new: NodeRef<'_>, old: NodeRef<'_>) -> bool {
        let (place, old_place) = (new.range(), old.range());
        let is_unchanged = old_place.start() >= self.change.range.end();
        is_unchanged && place.start() == self.change.moved(old_place.start()) && new.entries() == old.entries()
    }
}

/// A node whose children are not complete.
struct OpenGreenNode {
    kind: SyntaxKind,
    /// Index after the last entry of the node.
    end: usize,
    /// Index of the first child.
    first: usize,
}

fn build(sharing: &mut Sharing, piece: NodeRef<'_>) -> GreenElement {
    let (mut open, mut children) = (Vec::<OpenGreenNode>::new(), Vec::new());
    let mut text = piece.text();
    for (index, entry) in piece.indexes().zip(piece.entries()) {
        if entry.kind.is_node() {
            open.push(OpenGreenNode { kind: entry.kind, end: index + 1 + entry.size as usize, first: children.len() });
        } else {
            let (own, after) = text.split_at_checked(entry.len as usize).unwrap_or((text, ""));
            children.push(GreenElement::Token(sharing.token(entry.kind, own)));
            text = after;
        }
        while let Some(node) = open.pop_if(|node| node.end == index + 1) {
            let green = sharing.node(node.kind, children.drain(node.first..));
            children.push(GreenElement::Node(green));
        }
    }
    children.pop().unwrap_or_else(|| GreenElement::Token(sharing.token(SyntaxKind::ERROR_TOKEN, piece.text())))
}
