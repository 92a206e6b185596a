//! Text to tokens. XML and code have lexers of their own; this module knows which of them reads what.
//!
//! The code of a program is the content of the element `<Code>` (`<code>` in the old dialect), as a CDATA section
//! or as escaped text. The lexers take every text and lose no byte of it.

mod code;
mod entity;
mod foreign;
mod xml;

pub use entity::{decode_entities, resolve as resolve_entity};

use rowan::{TextRange, TextSize};

use crate::error::{SyntaxError, SyntaxErrorKind};
use crate::kind::SyntaxKind;
use crate::never::Part;

/// A token: its kind, where it ends in the text, and the indentation if it is the first of its line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Token {
    /// Byte offset after the token.
    pub(crate) end: u32,
    pub(crate) kind: SyntaxKind,
    pub(crate) indent: Indent,
}

/// Blanks before a token in its line of code, or the mark of a token that has others before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Indent(u16);

impl Indent {
    /// The token is not the first of its line.
    pub(crate) const NONE: Self = Self(u16::MAX);
    pub(crate) const ZERO: Self = Self(0);

    pub(crate) fn starts_line(self) -> bool {
        self != Self::NONE
    }

    /// `blanks` more. Beyond 65,534 all are the same.
    fn deeper(self, blanks: usize) -> Self {
        let sum = usize::from(self.0).saturating_add(blanks);
        if self.starts_line() { Self(u16::try_from(sum).unwrap_or(u16::MAX).min(u16::MAX - 1)) } else { self }
    }
}

/// The tokens of a whole text and the faults that only the lexer sees.
#[derive(Debug, Default)]
pub(crate) struct Lexed {
    pub(crate) tokens: Vec<Token>,
    pub(crate) errors: Vec<SyntaxError>,
    /// Keywords in another letter case than usual.
    pub(crate) odd_keywords: Vec<TextRange>,
    /// A comment, CDATA section or the like runs to the end of the text, which has been said.
    pub(crate) cut_off: bool,
}

/// Splits `text` into tokens.
pub(crate) fn lex(text: &str) -> Lexed {
    let mut lexer = Lexer::new(text);
    lexer.document();
    lexer.out
}

/// The state both lexers share: where we are, and what has come out.
struct Lexer<'t> {
    text: &'t str,
    pos: usize,
    out: Lexed,
    /// Indentation of the next token that is no trivia.
    indent: Indent,
    /// No `]]>` follows the current position. Determined once, so that no text is searched repeatedly.
    no_cdata_end: bool,
}

impl<'t> Lexer<'t> {
    fn new(text: &'t str) -> Self {
        let out = Lexed { tokens: Vec::with_capacity(text.len() / 3), ..Lexed::default() };
        Self { text, pos: 0, out, indent: Indent::NONE, no_cdata_end: false }
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

    /// The line of a merge conflict at the current position, which is the start of a line: where it ends.
    fn conflict_marker(&self) -> Option<usize> {
        let rest = self.rest().as_bytes();
        let at_line_start = self.pos == 0 || self.text.as_bytes().get(self.pos - 1) == Some(&b'\n');
        let starts = [&b"<<<<<<< "[..], b">>>>>>> ", b"||||||| ", ESCAPED_OPENING, ESCAPED_END];
        let marked = starts.iter().any(|start| rest.starts_with(start))
            || (rest.starts_with(b"=======") && matches!(rest.get(7), None | Some(b'\r' | b'\n')));
        (at_line_start && marked).then(|| self.line_end(self.pos))
    }

    /// Where the line that contains `from` ends, without its line end.
    fn line_end(&self, from: usize) -> usize {
        let bytes = self.text.as_bytes().part(from..);
        from + memchr::memchr2(b'\n', b'\r', bytes).unwrap_or(bytes.len())
    }

    /// Emits a conflict marker if one starts here.
    fn take_conflict_marker(&mut self) -> bool {
        let Some(end) = self.conflict_marker() else { return false };
        self.error(SyntaxErrorKind::ConflictMarker, self.pos, end);
        self.token(SyntaxKind::CONFLICT_MARKER, end);
        true
    }
}

/// The first and the last line of a conflict in escaped code.
const ESCAPED_OPENING: &[u8] = b"&lt;&lt;&lt;&lt;&lt;&lt;&lt; ";
const ESCAPED_END: &[u8] = b"&gt;&gt;&gt;&gt;&gt;&gt;&gt; ";

/// The start of a comment that holds the other versions of an element with a merge conflict.
const CONFLICT_COMMENT: &str = "<!-- <<<<<<<";

/// An offset of the text; texts are shorter than 4 GiB.
fn offset(at: usize) -> u32 {
    u32::try_from(at).unwrap_or(u32::MAX)
}

pub(crate) fn range(start: usize, end: usize) -> TextRange {
    TextRange::new(TextSize::new(offset(start)), TextSize::new(offset(end.max(start))))
}
