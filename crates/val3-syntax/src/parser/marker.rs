//! Starting and completing nodes.

use super::{Event, Parser};
use crate::kind::SyntaxKind;

/// A node that has been started.
pub(crate) struct Marker {
    /// Index of its `Start` event.
    at: usize,
    /// The height of the tallest sibling before it.
    siblings: u32,
}

impl Parser<'_> {
    /// Starts a node at the current token.
    pub(crate) fn start(&mut self) -> Marker {
        let at = self.events.len();
        self.events.push(Event::Abandoned);
        Marker { at, siblings: std::mem::take(&mut self.height) }
    }
}

impl Marker {
    pub(crate) fn complete(self, p: &mut Parser<'_>, kind: SyntaxKind) -> Completed {
        if let Some(event) = p.events.get_mut(self.at) {
            *event = Event::Start { kind, parent: 0 };
        }
        p.events.push(Event::Finish);
        let height = p.height + 1;
        p.height = height.max(self.siblings);
        Completed { at: self.at, kind, height, siblings: self.siblings }
    }

    /// Gives the node up; what it holds goes to the node around it.
    pub(crate) fn abandon(self, p: &mut Parser<'_>) {
        p.height = p.height.max(self.siblings);
        if self.at + 1 == p.events.len() {
            p.events.pop();
        }
    }
}

/// A node that is complete and may still get a node around it.
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

    /// Levels of nodes from this one down.
    pub(crate) fn height(self) -> u32 {
        self.height
    }

    /// Starts a node that encloses this one.
    pub(crate) fn precede(self, p: &mut Parser<'_>) -> Marker {
        let at = p.events.len();
        p.events.push(Event::Abandoned);
        p.height = self.height;
        if let Some(Event::Start { parent, .. }) = p.events.get_mut(self.at) {
            *parent = u32::try_from(at - self.at).unwrap_or(0);
        }
        Marker { at, siblings: self.siblings }
    }
}
