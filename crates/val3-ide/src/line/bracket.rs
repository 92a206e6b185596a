//! The brackets around the cursor that are no call: a literal `{…}`, an index `[…]`.

use val3_syntax::SyntaxKind::*;
use val3_syntax::SyntaxToken;

use super::{LineTokens, open_bracket, pieces};

/// The kind of the innermost bracket around the cursor.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Bracket<'t> {
    /// `{`, with the tokens before it.
    Literal(&'t [SyntaxToken]),
    /// `[`, with the tokens of what is indexed.
    Index(&'t [SyntaxToken]),
}

impl<'t> Bracket<'t> {
    /// The innermost bracket that is open at the cursor, and the value in it that the cursor is in, from 0; `None`
    /// where that is a parenthesis.
    pub(crate) fn around(line: &'t LineTokens) -> Option<(Self, usize)> {
        let before = line.before();
        let open = open_bracket(before)?;
        let (head, inside) = (before.get(..open)?, before.get(open + 1..)?);
        let bracket = match before.get(open)?.kind() {
            L_CURLY => Self::Literal(head),
            L_BRACK => Self::Index(head),
            _ => return None,
        };
        Some((bracket, pieces(inside).len().saturating_sub(1)))
    }
}
