//! Lexer: splits text into tokens. XML and code have separate lexers; this module chooses between them.
//!
//! The code of a program is the content of `<Code>` (`<code>` in the old dialect), as a CDATA section or as escaped
//! text. The lexers accept every text and omit no byte.

mod code;
mod entity;
mod foreign;
mod xml;

pub use entity::{decode_entities, resolve as resolve_entity};

use rowan::{TextRange, TextSize};

use crate::conflict::is_mark;
use crate::error::{SyntaxError, SyntaxErrorKind};
use crate::kind::SyntaxKind;
use crate::never::TextSlice;

/// A token: its kind, its end, and its indentation if it starts a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Token {
    /// Byte offset after the token.
    pub(crate) end: u32,
    pub(crate) kind: SyntaxKind,
    pub(crate) indent: Indent,
}

/// Number of blanks before a token that starts a line of code; a special value for other tokens.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Indent(u16);

impl Indent {
    /// A token that does not start a line.
    pub(crate) const NONE: Self = Self(u16::MAX);
    pub(crate) const ZERO: Self = Self(0);

    pub(crate) fn starts_line(self) -> bool {
        self != Self::NONE
    }

    /// Adds `blanks`, up to 65,534.
    fn deeper(self, blanks: usize) -> Self {
        let sum = usize::from(self.0).saturating_add(blanks);
        if self.starts_line() { Self(u16::try_from(sum).unwrap_or(u16::MAX).min(u16::MAX - 1)) } else { self }
    }
}

/// Tokens of a text, and the errors of the lexer.
#[derive(Debug, Default)]
pub(crate) struct Lexed {
    pub(crate) tokens: Vec<Token>,
    pub(crate) errors: Vec<SyntaxError>,
    /// Keywords in unusual letter case.
    pub(crate) odd_keywords: Vec<TextRange>,
    /// Whether a comment, CDATA section or similar part continues to the end of the text, which was already reported.
    pub(crate) cut_off: bool,
}

/// Splits `text` into tokens.
pub(crate) fn lex(text: &str) -> Lexed {
    let mut lexer = Lexer::new(text);
    lexer.document();
    lexer.out
}

/// State that both lexers share: position and output.
struct Lexer<'t> {
    text: &'t str,
    pos: usize,
    out: Lexed,
    /// Indentation of the next non-trivia token.
    indent: Indent,
    /// Beginning of the code that is read.
    code_start: usize,
    /// Whether no `]]>` follows the current position. Computed once, so that no text is searched repeatedly.
    no_cdata_end: bool,
}

impl<'t> Lexer<'t> {
    fn new(text: &'t str) -> Self {
        let out = Lexed { tokens: Vec::with_capacity(text.len() / 3), ..Lexed::default() };
        Self { text, pos: 0, out, indent: Indent::NONE, code_start: 0, no_cdata_end: false }
    }

    fn rest(&self) -> &'t str {
        self.text.part(self.pos..)
    }

    fn byte(&self) -> Option<u8> {
        self.text.as_bytes().get(self.pos).copied()
    }

    /// Emits the text up to `end` as one token.
    fn token(&mut self, kind: SyntaxKind, end: usize) {
        debug_assert!(end > self.pos && self.text.is_char_boundary(end));
        self.pos = end;
        let indent = self.indent;
        if !kind.is_trivia() {
            self.indent = Indent::NONE;
        }
        self.out.tokens.push(Token { end: offset(end), kind, indent });
    }

    fn error(&mut self, kind: SyntaxErrorKind, start: usize, end: usize) {
        self.out.errors.push(SyntaxError { kind, range: range(start, end), related: None });
    }

    /// Returns the end of the merge conflict marker at the current position, if there is one at the start of a line.
    fn conflict_marker(&self) -> Option<usize> {
        let rest = self.rest().as_bytes();
        let at_line_start = self.pos == 0 || self.text.as_bytes().get(self.pos - 1) == Some(&b'\n');
        let marked =
            is_mark(rest) || (rest.starts_with(b"=======") && matches!(rest.get(7), None | Some(b'\r' | b'\n')));
        (at_line_start && marked).then(|| self.line_end(self.pos))
    }

    /// Returns the end of the line that contains `from`, without its line end.
    fn line_end(&self, from: usize) -> usize {
        let bytes = self.text.as_bytes().part(from..);
        from + memchr::memchr2(b'\n', b'\r', bytes).unwrap_or(bytes.len())
    }

    /// Emits a conflict marker if one starts here. Returns whether it does.
    fn take_conflict_marker(&mut self) -> bool {
        let Some(end) = self.conflict_marker() else { return false };
        self.error(SyntaxErrorKind::ConflictMarker, self.pos, end);
        self.token(SyntaxKind::CONFLICT_MARKER, end);
        true
    }
}

/// Converts an offset; texts are shorter than 4 GiB.
fn offset(at: usize) -> u32 {
    u32::try_from(at).unwrap_or(u32::MAX)
}

pub(crate) fn range(start: usize, end: usize) -> TextRange {
    TextRange::new(TextSize::new(offset(start)), TextSize::new(offset(end.max(start))))
}
