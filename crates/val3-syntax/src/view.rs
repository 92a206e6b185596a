//! Walking down a tree without allocating.
//!
//! The typed AST is the comfortable way to read a tree. The queries that read every program of a workspace use
//! these views instead, which are plain copies of a reference and a place.

use rowan::{NodeOrToken, TextRange, TextSize};

use crate::kind::SyntaxKind;
use crate::tree::Piece;

pub use crate::tree::visits;

/// A node and its position.
#[derive(Debug, Clone, Copy)]
pub struct View<'t>(Piece<'t>);

/// A token and its position.
#[derive(Debug, Clone, Copy)]
pub struct TokenView<'t>(Piece<'t>);

impl<'t> View<'t> {
    pub(crate) fn new(node: Piece<'t>) -> Self {
        Self(node)
    }

    /// The kind of the node.
    pub fn kind(self) -> SyntaxKind {
        self.0.kind()
    }

    /// The range of the node.
    pub fn range(self) -> TextRange {
        self.0.range()
    }

    /// Nodes and tokens below, in order.
    pub fn children_with_tokens(self) -> impl Iterator<Item = NodeOrToken<View<'t>, TokenView<'t>>> {
        self.0.children().map(|piece| match piece.kind().is_node() {
            true => NodeOrToken::Node(View(piece)),
            false => NodeOrToken::Token(TokenView(piece)),
        })
    }

    /// Nodes below, in order.
    pub fn children(self) -> impl Iterator<Item = View<'t>> {
        self.0.children().filter(|piece| piece.kind().is_node()).map(View)
    }

    /// Tokens directly below, without trivia.
    pub fn tokens(self) -> impl Iterator<Item = TokenView<'t>> {
        let is_solid = |kind: SyntaxKind| !kind.is_node() && !kind.is_trivia();
        self.0.children().filter(move |piece| is_solid(piece.kind())).map(TokenView)
    }

    /// How many nodes and tokens are of a wanted kind, this one and all below.
    pub fn count(self, is_wanted: impl Fn(SyntaxKind) -> bool) -> usize {
        self.0.entries().iter().filter(|entry| is_wanted(entry.kind)).count()
    }

    /// The first node of `kind` below.
    pub fn child(self, kind: SyntaxKind) -> Option<View<'t>> {
        self.children().find(|child| child.kind() == kind)
    }

    /// The first token of `kind` directly below.
    pub fn token(self, kind: SyntaxKind) -> Option<TokenView<'t>> {
        self.0.children().find(|piece| piece.kind() == kind && !kind.is_node()).map(TokenView)
    }

    /// The nodes that hold `range`, from this one to the innermost. An empty range between two nodes is in the first.
    pub fn path_to(self, range: TextRange) -> impl Iterator<Item = View<'t>> {
        self.0.path_to(range).map(View)
    }
}

impl<'t> TokenView<'t> {
    /// The kind of the token.
    pub fn kind(self) -> SyntaxKind {
        self.0.kind()
    }

    /// The text, in the form of the file.
    pub fn text(self) -> &'t str {
        self.0.text()
    }

    /// The text of the token is `text`.
    pub fn is(self, text: &str) -> bool {
        self.0.range().len() == TextSize::of(text) && self.text() == text
    }

    /// The range of the token.
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
