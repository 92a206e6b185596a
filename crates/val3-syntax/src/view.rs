//! Walking a tree without allocating: a green node with its place.
//!
//! The typed AST is the comfortable way to read a tree. The queries that read every program of a workspace use
//! these views instead, which are plain copies of a reference and an offset.

use rowan::{GreenNodeData, GreenTokenData, NodeOrToken, TextRange, TextSize};

use crate::kind::SyntaxKind;

/// A node and where it starts.
#[derive(Debug, Clone, Copy)]
pub struct View<'g> {
    green: &'g GreenNodeData,
    start: TextSize,
}

/// A token and where it starts.
#[derive(Debug, Clone, Copy)]
pub struct TokenView<'g> {
    green: &'g GreenTokenData,
    start: TextSize,
}

impl<'g> View<'g> {
    /// The root of a tree.
    pub fn root(green: &'g GreenNodeData) -> Self {
        Self { green, start: TextSize::new(0) }
    }

    /// The kind of the node.
    pub fn kind(self) -> SyntaxKind {
        SyntaxKind::from_raw(self.green.kind())
    }

    /// Where the node stands.
    pub fn range(self) -> TextRange {
        TextRange::at(self.start, self.green.text_len())
    }

    /// Nodes and tokens below, in order.
    pub fn children_with_tokens(self) -> impl Iterator<Item = NodeOrToken<View<'g>, TokenView<'g>>> {
        let mut at = self.start;
        self.green.children().map(move |child| {
            let start = at;
            at += match child {
                NodeOrToken::Node(node) => node.text_len(),
                NodeOrToken::Token(token) => token.text_len(),
            };
            match child {
                NodeOrToken::Node(green) => NodeOrToken::Node(View { green, start }),
                NodeOrToken::Token(green) => NodeOrToken::Token(TokenView { green, start }),
            }
        })
    }

    /// Nodes below, in order.
    pub fn children(self) -> impl Iterator<Item = View<'g>> {
        self.children_with_tokens().filter_map(NodeOrToken::into_node)
    }

    /// Tokens directly below, without trivia.
    pub fn tokens(self) -> impl Iterator<Item = TokenView<'g>> {
        self.children_with_tokens().filter_map(NodeOrToken::into_token).filter(|token| !token.kind().is_trivia())
    }

    /// The first node of `kind` below.
    pub fn child(self, kind: SyntaxKind) -> Option<View<'g>> {
        self.children().find(|child| child.kind() == kind)
    }

    /// The first token of `kind` directly below.
    pub fn token(self, kind: SyntaxKind) -> Option<TokenView<'g>> {
        self.children_with_tokens().filter_map(NodeOrToken::into_token).find(|token| token.kind() == kind)
    }
}

impl<'g> TokenView<'g> {
    /// The kind of the token.
    pub fn kind(self) -> SyntaxKind {
        SyntaxKind::from_raw(self.green.kind())
    }

    /// The text as it stands in the file.
    pub fn text(self) -> &'g str {
        self.green.text()
    }

    /// Where the token stands.
    pub fn range(self) -> TextRange {
        TextRange::at(self.start, self.green.text_len())
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
        let root = View::root(parse.green());
        let code = root.child(SyntaxKind::ELEMENT).and_then(|element| element.child(SyntaxKind::CODE)).unwrap();
        let statement = code.child(SyntaxKind::BLOCK).and_then(|block| block.children().next()).unwrap();
        assert_eq!(&text[statement.range()], "a=b[1]");
        assert_eq!(&text[statement.token(SyntaxKind::EQ).unwrap().range()], "=");
        assert_eq!(code.tokens().map(TokenView::text).collect::<Vec<_>>(), ["begin", "end"]);
        assert_eq!(root.range(), TextRange::up_to(TextSize::of(text)));
    }
}
