//! The kinds as a rowan language, and its tree types.

use super::SyntaxKind;

/// Language of the trees, for rowan.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Val3 {}

impl rowan::Language for Val3 {
    type Kind = SyntaxKind;

    fn kind_from_raw(raw: rowan::SyntaxKind) -> SyntaxKind {
        SyntaxKind::from_raw(raw)
    }

    fn kind_to_raw(kind: SyntaxKind) -> rowan::SyntaxKind {
        kind.into()
    }
}

/// A node of the tree.
pub type SyntaxNode = rowan::SyntaxNode<Val3>;
/// A token of the tree.
pub type SyntaxToken = rowan::SyntaxToken<Val3>;
/// A node or a token.
pub type SyntaxElement = rowan::SyntaxElement<Val3>;
