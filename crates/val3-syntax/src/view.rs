//! Views, which walk down a tree without allocations.
//!
//! Typed AST nodes are more convenient. Views are plain copies of a reference and an index, for queries that read every
//! program of a workspace.

use rowan::{NodeOrToken, TextRange, TextSize};

use crate::kind::SyntaxKind;
use crate::tree::NodeRef;

pub use crate::tree::visits;

/// A node with its position.
#[derive(Debug, Clone, Copy)]
pub struct View<'t>(NodeRef<'t>);

/// A token with its position.
#[derive(Debug, Clone, Copy)]
pub struct TokenView<'t>(NodeRef<'t>);

impl<'t> View<'t> {
    pub(crate) fn new(node: NodeRef<'t>) -> Self {
        Self(node)
    }

    /// Returns the kind of the node.
    pub fn kind(self) -> SyntaxKind {
        self.0.kind()
    }

    /// Returns the range of the node.
    pub fn range(self) -> TextRange {
        self.0.range()
    }

    /// Returns the child nodes and tokens in order.
    pub fn children_with_tokens(self) -> impl Iterator<Item = NodeOrToken<View<'t>, TokenView<'t>>> {
        self.0.children().map(|piece| match piece.kind().is_node() {
            true => NodeOrToken::Node(View(piece)),
            false => NodeOrToken::Token(TokenView(piece)),
        })
    }

    /// Returns the child nodes in order.
    pub fn children(self) -> impl Iterator<Item = View<'t>> {
        self.0.children().filter(|piece| piece.kind().is_node()).map(View)
    }

    /// Returns the child tokens without trivia.
    pub fn tokens(self) -> impl Iterator<Item = TokenView<'t>> {
        self.0.children().filter(|piece| !piece.kind().is_node() && !piece.kind().is_trivia()).map(TokenView)
    }

    /// Returns the number of nodes and tokens for which `is_wanted` is true, including this node and all below it.
    pub fn count(self, is_wanted: impl Fn(SyntaxKind) -> bool) -> usize {
        self.0.entries().iter().filter(|entry| is_wanted(entry.kind)).count()
    }

    /// Returns the first child node of `kind`.
    pub fn child(self, kind: SyntaxKind) -> Option<View<'t>> {
        self.children().find(|child| child.kind() == kind)
    }

    /// Returns the first child token of `kind`.
    pub fn token(self, kind: SyntaxKind) -> Option<TokenView<'t>> {
        self.0.children().find(|piece| piece.kind() == kind && !kind.is_node()).map(TokenView)
    }

    /// Returns the nodes that contain `range`, from this one to the innermost. An empty range between two nodes is in
    /// the first.
    pub fn path_to(self, range: TextRange) -> impl Iterator<Item = View<'t>> {
        self.0.path_to(range).map(View)
    }
}

impl<'t> TokenView<'t> {
    /// Returns the kind of the token.
    pub fn kind(self) -> SyntaxKind {
        self.0.kind()
    }

    /// Returns the text as written in the file.
    pub fn text(self) -> &'t str {
        self.0.text()
    }

    /// Whether the token has the text `text`.
    pub fn is(self, text: &str) -> bool {
        self.0.range().len() == TextSize::of(text) && self.text() == text
    }

    /// Returns the range of the token.
    pub fn range(self) -> TextRange {
        self.0.range()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    #[test]
    fn ranges_are_those_of_the_file() {
        let text = "<Code><![CDATA[begin\n  a=b[1] // c\nend]]></Code>";
        let parse = parse(text);
        let root = parse.view();
        let code = root.child(SyntaxKind::ELEMENT).and_then(|element| element.child(SyntaxKind::CODE)).unwrap();
        let statement = code.child(SyntaxKind::BLOCK).and_then(|block| block.children().next()).unwrap();
        assert_eq!(&text[statement.range()], "a=b[1]");
        assert_eq!(&text[statement.token(SyntaxKind::EQ).unwrap().range()], "=");
        assert_eq!(code.tokens().map(TokenView::text).collect::<Vec<_>>(), ["begin", "end"]);
        assert_eq!(root.range(), TextRange::up_to(TextSize::of(text)));
    }
}
