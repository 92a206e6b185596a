//! Input of the grammar: the non-trivia tokens.

use rowan::TextRange;

use crate::kind::SyntaxKind;
use crate::lexer::{Indent, Lexed, Token, range};
use crate::never::text_at;

/// The non-trivia tokens of a text.
pub(crate) struct Input<'t> {
    text: &'t str,
    tokens: &'t [Token],
    solid: Vec<TokenInfo>,
    cut_off: bool,
    /// Number of token accesses.
    #[cfg(test)]
    pub(crate) looks: std::cell::Cell<usize>,
}

/// The most used properties of a token, and its index.
#[derive(Clone, Copy)]
struct TokenInfo {
    kind: SyntaxKind,
    indent: Indent,
    /// Index among all tokens.
    index: u32,
}

impl<'t> Input<'t> {
    pub(crate) fn new(text: &'t str, lexed: &'t Lexed) -> Self {
        let tokens = lexed.tokens.as_slice();
        let mut solid = Vec::with_capacity(tokens.len());
        for (index, token) in (0u32..).zip(tokens) {
            if !token.kind.is_trivia() {
                solid.push(TokenInfo { kind: token.kind, indent: token.indent, index });
            }
        }
        Self {
            text,
            tokens,
            solid,
            cut_off: lexed.cut_off,
            #[cfg(test)]
            looks: std::cell::Cell::default(),
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.solid.len()
    }

    /// Whether the lexer has already reported a truncated text.
    pub(crate) fn is_cut_off(&self) -> bool {
        self.cut_off
    }

    pub(crate) fn kind(&self, pos: usize) -> SyntaxKind {
        #[cfg(test)]
        self.looks.set(self.looks.get() + 1);
        self.solid.get(pos).map_or(SyntaxKind::EOF, |token| token.kind)
    }

    /// Returns the indentation if the token starts a line.
    pub(crate) fn indent(&self, pos: usize) -> Indent {
        self.solid.get(pos).map_or(Indent::NONE, |token| token.indent)
    }

    pub(crate) fn range(&self, pos: usize) -> TextRange {
        let Some(token) = self.solid.get(pos) else {
            return range(self.text.len(), self.text.len());
        };
        let index = token.index as usize;
        let start = index.checked_sub(1).and_then(|before| self.tokens.get(before)).map_or(0, |token| token.end);
        let end = self.tokens.get(index).map_or(start, |token| token.end);
        range(start as usize, end as usize)
    }

    pub(crate) fn text(&self, pos: usize) -> &'t str {
        text_at(self.text, self.range(pos))
    }
}
