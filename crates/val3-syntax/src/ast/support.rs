//! What every typed node builds on.

use std::marker::PhantomData;

use rowan::{NodeOrToken, TextRange};

use crate::kind::{SyntaxKind, SyntaxNode, SyntaxToken};

/// A typed view of a node.
pub trait AstNode: Sized {
    /// A node of `kind` can be viewed as this type.
    fn can_cast(kind: SyntaxKind) -> bool;
    /// The typed view of `syntax`, if its kind fits.
    fn cast(syntax: SyntaxNode) -> Option<Self>;
    /// The node itself.
    fn syntax(&self) -> &SyntaxNode;
}

/// The children of a node that can be viewed as `N` and lie in a range.
#[derive(Debug, Clone)]
pub struct AstChildren<N> {
    inner: rowan::SyntaxNodeChildren<crate::kind::Val3>,
    range: TextRange,
    kind: PhantomData<N>,
}

impl<N: AstNode> Iterator for AstChildren<N> {
    type Item = N;

    fn next(&mut self) -> Option<N> {
        let range = self.range;
        self.inner.by_ref().filter(|child| range.contains_range(child.text_range())).find_map(N::cast)
    }
}

/// The first child that is an `N`.
pub fn child<N: AstNode>(parent: &SyntaxNode) -> Option<N> {
    parent.children().find_map(N::cast)
}

/// All children that are an `N`.
pub fn children<N: AstNode>(parent: &SyntaxNode) -> AstChildren<N> {
    AstChildren { inner: parent.children(), range: parent.text_range(), kind: PhantomData }
}

/// The first of [`children_between`].
pub fn child_between<N: AstNode>(parent: &SyntaxNode, after: &[SyntaxKind], before: &[SyntaxKind]) -> Option<N> {
    children_between(parent, after, before).next()
}

/// The children that are an `N`, behind the first token of a kind in `after` and before the next of a kind in
/// `before`. An empty list, and a missing token of `before`, stand for the start and the end of the node; without
/// its token of `after` there is no such child.
pub fn children_between<N: AstNode>(
    parent: &SyntaxNode,
    after: &[SyntaxKind],
    before: &[SyntaxKind],
) -> AstChildren<N> {
    let whole = parent.text_range();
    let start = match after {
        [] => whole.start(),
        kinds => token_of(parent, kinds).map_or(whole.end(), |token| token.text_range().end()),
    };
    let is_end = |token: &SyntaxToken| before.contains(&token.kind()) && token.text_range().start() >= start;
    let end = tokens(parent).find(is_end).map_or(whole.end(), |token| token.text_range().start());
    AstChildren { inner: parent.children(), range: TextRange::new(start, end), kind: PhantomData }
}

/// The first token of `kind` directly below `parent`.
pub fn token(parent: &SyntaxNode, kind: SyntaxKind) -> Option<SyntaxToken> {
    token_of(parent, &[kind])
}

/// The first token of one of `kinds` directly below `parent`.
pub fn token_of(parent: &SyntaxNode, kinds: &[SyntaxKind]) -> Option<SyntaxToken> {
    tokens(parent).find(|token| kinds.contains(&token.kind()))
}

fn tokens(parent: &SyntaxNode) -> impl Iterator<Item = SyntaxToken> + use<> {
    parent.children_with_tokens().filter_map(NodeOrToken::into_token)
}
