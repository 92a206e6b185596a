//! Brackets around the cursor other than calls: a literal `{…}` or an index `[…]`.

use val3_syntax::SyntaxKind::*;
use val3_syntax::SyntaxToken;

use super::{LineTokens, open_bracket, pieces};

/// Kind of the innermost bracket that contains the cursor.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Bracket<'t> {
    /// `{`, with the tokens before it.
    Literal(&'t [SyntaxToken]),
    /// `[`, with the tokens of the indexed expression.
    Index(&'t [SyntaxToken]),
}

impl<'t> Bracket<'t> {
    /// Innermost open bracket at the cursor, and the index of the value at the cursor, from 0. `None` if the innermost
    /// bracket is a parenthesis.
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
