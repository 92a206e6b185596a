//! Markers, which start and complete nodes.

use super::{ParseEvent, Parser};
use crate::kind::SyntaxKind;

/// A started node.
pub(crate) struct Marker {
    /// Index of the node's `Start` event.
    at: usize,
    /// Maximum height of the preceding siblings.
    siblings: u32,
}

impl Parser<'_> {
    /// Starts a node at the current token.
    pub(crate) fn start(&mut self) -> Marker {
        let at = self.events.len();
        self.events.push(ParseEvent::Abandoned);
        Marker { at, siblings: std::mem::take(&mut self.height) }
    }
}

impl Marker {
    pub(crate) fn complete(self, p: &mut Parser<'_>, kind: SyntaxKind) -> Completed {
        if let Some(event) = p.events.get_mut(self.at) {
            *event = ParseEvent::Start { kind, parent: 0 };
        }
        p.events.push(ParseEvent::Finish);
        let height = p.height + 1;
        p.height = height.max(self.siblings);
        Completed { at: self.at, kind, height, siblings: self.siblings }
    }

    /// Abandons the node; its content becomes content of the parent node.
    pub(crate) fn abandon(self, p: &mut Parser<'_>) {
        p.height = p.height.max(self.siblings);
        if self.at + 1 == p.events.len() {
            p.events.pop();
        }
    }
}

/// A completed node, around which another node can still be started.
#[derive(Clone, Copy)]
pub(crate) struct Completed {
    at: usize,
    kind: SyntaxKind,
    height: u32,
    siblings: u32,
}

impl Completed {
    pub(crate) fn kind(self) -> SyntaxKind {
        self.kind
    }

    /// Returns the height of the node in levels.
    pub(crate) fn height(self) -> u32 {
        self.height
    }

    /// Starts a node that encloses this node.
    pub(crate) fn precede(self, p: &mut Parser<'_>) -> Marker {
        let at = p.events.len();
        p.events.push(ParseEvent::Abandoned);
        p.height = self.height;
        if let Some(ParseEvent::Start { parent, .. }) = p.events.get_mut(self.at) {
            *parent = u32::try_from(at - self.at).unwrap_or(0);
        }
        Marker { at, siblings: self.siblings }
    }
}
