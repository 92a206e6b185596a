//! Lexer of VAL 3 code: the content of `<Code>`, in CDATA sections or as escaped text.

use memchr::{memchr, memchr2, memrchr2};

use super::xml::CDATA;
use super::{Indent, Lexer, entity, foreign};
use crate::error::{SyntaxError, SyntaxErrorKind};
use crate::kind::SyntaxKind::{self, *};
use crate::never::TextSlice;

/// A segment of code between XML markup.
#[derive(Clone, Copy)]
struct CodeSegment {
    end: usize,
    /// Whether `<` and `&` are written as entity references.
    escaped: bool,
}

impl Lexer<'_> {
    /// Reads everything between `<Code>` and `</Code>`.
    pub(super) fn code_content(&mut self) {
        self.indent = Indent::ZERO;
        self.code_start = self.pos;
        while let Some(byte) = self.byte() {
            let rest = self.rest();
            if byte != b'<' {
                let end = memchr(b'<', rest.as_bytes()).map_or(self.text.len(), |at| self.pos + at);
                self.code(CodeSegment { end, escaped: true });
            } else if rest.starts_with("</") {
                return;
            } else if !self.take_conflict_marker() {
                self.code_markup();
            }
        }
    }

    /// Reads `<` between code segments.
    fn code_markup(&mut self) {
        let rest = self.rest();
        if rest.starts_with(CDATA) {
            let end = self.cdata_end();
            self.token(CDATA_OPEN, self.pos + CDATA.len());
            self.code(CodeSegment { end, escaped: false });
            self.cdata_close();
        } else if rest.starts_with("<!--") {
            self.comment_of_xml();
        } else {
            // A comparison that was not escaped.
            self.error(SyntaxErrorKind::UnexpectedText, self.pos, self.pos + 1);
            let (kind, len) = if rest.starts_with("<=") { (LE, 2) } else { (LT, 1) };
            self.token(kind, self.pos + len);
        }
    }

    fn code(&mut self, stretch: CodeSegment) {
        while self.pos < stretch.end {
            self.code_token(stretch);
        }
    }

    fn code_token(&mut self, stretch: CodeSegment) {
        let Some(byte) = self.byte() else { return };
        match byte {
            b' ' | b'\t' | 0x0b | 0x0c => self.code_blanks(stretch),
            b'\n' | b'\r' => self.line_break(stretch),
            b'a'..=b'z' | b'A'..=b'Z' | b'_' | b'$' => self.word(stretch),
            b'0'..=b'9' => self.number(stretch),
            b'.' if self.next_byte(stretch).is_some_and(|byte| byte.is_ascii_digit()) => self.number(stretch),
            b'"' => self.string(stretch, 1),
            b'/' if self.next_byte(stretch) == Some(b'/') => self.comment(stretch),
            b'&' if stretch.escaped => self.reference(stretch),
            b']' if stretch.escaped && self.is_cdata_close(stretch) => self.stray_cdata_close(),
            _ => self.operator(stretch, byte),
        }
    }

    /// Whether a `]]>` ends the code without an open CDATA section.
    fn is_cdata_close(&self, stretch: CodeSegment) -> bool {
        self.stretch_bytes(stretch).strip_prefix(b"]]>").is_some_and(|after| after.trim_ascii().is_empty())
    }

    /// Reports a `]]>` without a CDATA section, unless damage at the start of this code was reported.
    fn stray_cdata_close(&mut self) {
        let start = self.code_start;
        let mut of_code = self.out.errors.iter().rev().take_while(|error| usize::from(error.range.start()) >= start);
        if !of_code.any(|error| self.is_damage_at_start(error)) {
            self.error(SyntaxErrorKind::UnexpectedText, self.pos, self.pos + 3);
        }
        self.token(CDATA_CLOSE, self.pos + 3);
    }

    /// Whether an error in this code is unexpected text that only whitespace precedes.
    fn is_damage_at_start(&self, error: &SyntaxError) -> bool {
        let before = self.text.as_bytes().part(self.code_start..error.range.start().into());
        error.kind == SyntaxErrorKind::UnexpectedText && before.trim_ascii().is_empty()
    }

    fn next_byte(&self, stretch: CodeSegment) -> Option<u8> {
        self.stretch_bytes(stretch).get(1).copied()
    }

    /// Returns the bytes from the current position to the end of the segment.
    fn stretch_bytes(&self, stretch: CodeSegment) -> &[u8] {
        self.text.as_bytes().part(self.pos..stretch.end)
    }

    fn code_blanks(&mut self, stretch: CodeSegment) {
        let bytes = self.stretch_bytes(stretch);
        let len = bytes.iter().position(|byte| !matches!(byte, b' ' | b'\t' | 0x0b | 0x0c)).unwrap_or(bytes.len());
        self.indent = self.indent.deeper(len);
        self.token(WHITESPACE, self.pos + len);
    }

    /// Reads a line end with all following blank lines and indentation.
    fn line_break(&mut self, stretch: CodeSegment) {
        let bytes = self.stretch_bytes(stretch);
        let len = bytes.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(bytes.len());
        let indent = len - memrchr2(b'\n', b'\r', bytes.part(..len)).map_or(0, |at| at + 1);
        self.token(NEWLINE, self.pos + len);
        self.indent = Indent::ZERO.deeper(indent);
        if indent == 0 && self.conflict_marker().is_some_and(|end| end <= stretch.end) {
            self.take_conflict_marker();
        }
    }

    fn word(&mut self, stretch: CodeSegment) {
        let bytes = self.stretch_bytes(stretch);
        let mut rest = bytes.iter().skip(1);
        let end = rest.position(|byte| !byte.is_ascii_alphanumeric() && *byte != b'_');
        let len = 1 + end.unwrap_or(bytes.len() - 1);
        let end = self.pos + len;
        let foreign = if self.indent.starts_line() { foreign::word(bytes, len) } else { None };
        match foreign {
            Some((len, instead)) => {
                let end = self.pos + len;
                let found = self.text.part(self.pos..end).to_owned();
                self.error(SyntaxErrorKind::ForeignSpelling { found, instead }, self.pos, end);
                self.token(SyntaxKind::from_keyword(instead).unwrap_or(IDENT), end);
            }
            None => {
                let text = self.text.part(self.pos..end);
                let kind = SyntaxKind::from_keyword(text).unwrap_or(IDENT);
                if kind.keyword_text().is_some_and(|usual| usual != text) {
                    self.out.odd_keywords.push(super::range(self.pos, end));
                }
                self.token(kind, end);
            }
        }
    }

    /// Reads a number: `12`, `12.5`, `.5`, `1e3`, `1e-3`.
    fn number(&mut self, stretch: CodeSegment) {
        let bytes = self.stretch_bytes(stretch);
        let digits = |from: usize| bytes.part(from..).iter().take_while(|byte| byte.is_ascii_digit()).count();
        let mut len = digits(0);
        if bytes.get(len) == Some(&b'.') && digits(len + 1) > 0 {
            len += 1 + digits(len + 1);
        }
        if matches!(bytes.get(len), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(len + 1), Some(b'+' | b'-')));
            let exponent = digits(len + 1 + sign);
            if exponent > 0 {
                len += 1 + sign + exponent;
            }
        }
        let end = self.pos + len;
        if self.text.get(self.pos..end).is_some_and(is_too_large) {
            self.error(SyntaxErrorKind::NumberTooLarge, self.pos, end);
        }
        self.token(NUMBER, end);
    }

    /// Reads a string from its opening quote of `quote` bytes on. It has no escapes and ends on its line.
    fn string(&mut self, stretch: CodeSegment, quote: usize) {
        let start = self.pos;
        let mut at = start + quote;
        loop {
            match self.text.as_bytes().get(at).filter(|_| at < stretch.end) {
                Some(b'"') => return self.string_token(stretch, at + 1),
                Some(b'&') if stretch.escaped => match self.text.get(at..stretch.end).and_then(entity::resolve) {
                    Some(('"', len)) => return self.string_token(stretch, at + len),
                    Some((_, len)) => at += len,
                    None => at += 1,
                },
                Some(b'\n' | b'\r') | None => break,
                Some(_) => at += 1,
            }
        }
        // If the file is truncated, only the unclosed element is reported.
        if at < self.text.len() {
            self.error(SyntaxErrorKind::UnterminatedString, start, at);
        }
        self.string_token(stretch, at);
    }

    fn string_token(&mut self, stretch: CodeSegment, end: usize) {
        if stretch.escaped {
            self.check_entities(self.pos, end);
        }
        self.token(STRING, end);
    }

    /// Reads a comment. Code before it on its line is an error.
    fn comment(&mut self, stretch: CodeSegment) {
        let bytes = self.stretch_bytes(stretch);
        let end = self.pos + memchr2(b'\n', b'\r', bytes).unwrap_or(bytes.len());
        if !self.indent.starts_line() {
            self.error(SyntaxErrorKind::CommentAfterCode, self.pos, end);
        }
        if stretch.escaped {
            self.check_entities(self.pos, end);
        }
        self.token(COMMENT, end);
    }

    /// Reads an entity reference in escaped code as the character that it encodes.
    fn reference(&mut self, stretch: CodeSegment) {
        let rest = self.text.part(self.pos..stretch.end);
        let Some((character, len)) = entity::resolve(rest) else {
            self.unknown_entity(self.pos);
            return self.token(ERROR_TOKEN, self.pos + 1);
        };
        let with_eq = rest.as_bytes().get(len) == Some(&b'=');
        let end = self.pos + len;
        match character {
            '<' if with_eq => self.token(LE, end + 1),
            '<' => self.token(LT, end),
            '>' if with_eq => self.token(GE, end + 1),
            '>' => self.token(GT, end),
            '"' => self.string(stretch, len),
            // The parser reports `&&` with its VAL 3 spelling.
            '&' if rest.get(len..).is_some_and(|after| after.starts_with("&amp;")) => self.token(ERROR_TOKEN, end + 5),
            '\n' | '\r' => {
                self.token(NEWLINE, end);
                self.indent = Indent::ZERO;
            }
            ' ' | '\t' => self.token(WHITESPACE, end),
            _ => {
                self.error(SyntaxErrorKind::InvalidCharacter { character }, self.pos, end);
                self.token(ERROR_TOKEN, end);
            }
        }
    }

    fn operator(&mut self, stretch: CodeSegment, byte: u8) {
        let with_eq = self.next_byte(stretch) == Some(b'=');
        let (kind, len) = match byte {
            b'=' if with_eq => (EQ2, 2),
            b'=' => (EQ, 1),
            b'!' if with_eq => (NEQ, 2),
            b'!' => (BANG, 1),
            b'<' if with_eq => (LE, 2),
            b'<' => (LT, 1),
            b'>' if with_eq => (GE, 2),
            b'>' => (GT, 1),
            b'+' => (PLUS, 1),
            b'-' => (MINUS, 1),
            b'*' => (STAR, 1),
            b'/' => (SLASH, 1),
            b'%' => (PERCENT, 1),
            b'(' => (L_PAREN, 1),
            b')' => (R_PAREN, 1),
            b'[' => (L_BRACK, 1),
            b']' => (R_BRACK, 1),
            b'{' => (L_CURLY, 1),
            b'}' => (R_CURLY, 1),
            b',' => (COMMA, 1),
            b'.' => (DOT, 1),
            b':' => (COLON, 1),
            b'?' => (QUESTION, 1),
            _ => return self.invalid_characters(stretch),
        };
        self.token(kind, self.pos + len);
    }

    /// Reads a sequence of characters that are invalid in VAL 3 as one token with one error. The parser reports `&&`
    /// and `||` with their VAL 3 spelling.
    fn invalid_characters(&mut self, stretch: CodeSegment) {
        let rest = self.text.part(self.pos..stretch.end);
        if rest.starts_with("&&") || rest.starts_with("||") {
            return self.token(ERROR_TOKEN, self.pos + 2);
        }
        let Some(character) = rest.chars().next() else {
            return self.token(ERROR_TOKEN, stretch.end);
        };
        let run = rest.bytes().position(|byte| byte.is_ascii()).unwrap_or(rest.len());
        let end = self.pos + run.max(1);
        self.error(SyntaxErrorKind::InvalidCharacter { character }, self.pos, end);
        self.token(ERROR_TOKEN, end);
    }
}

/// Whether a number is beyond the range of `num`.
fn is_too_large(number: &str) -> bool {
    number.parse().is_ok_and(f64::is_infinite)
}
