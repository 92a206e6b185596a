//! Lexer of the XML around the code.

use memchr::{memchr, memchr2, memmem};

use super::{Lexer, entity};
use crate::conflict::CONFLICT_COMMENT;
use crate::error::{SyntaxErrorKind, XmlPart};
use crate::kind::SyntaxKind::{self, *};
use crate::never::TextSlice;

impl Lexer<'_> {
    /// Reads the entire file.
    pub(super) fn document(&mut self) {
        if self.rest().starts_with('\u{feff}') {
            self.token(BYTE_ORDER_MARK, 3);
        }
        while let Some(byte) = self.byte() {
            match byte {
                b'<' => self.markup(),
                _ => self.character_data(),
            }
        }
    }

    /// Reads markup that starts with `<`.
    fn markup(&mut self) {
        if self.take_conflict_marker() {
            return;
        }
        let rest = self.rest();
        if rest.starts_with("<!--") {
            self.comment_of_xml();
        } else if rest.starts_with("<![CDATA[") {
            self.cdata();
        } else if rest.starts_with("<!") {
            self.error(SyntaxErrorKind::Doctype, self.pos, self.pos + 2);
            self.until(">", XML_DOCTYPE, XmlPart::Tag);
        } else if rest.starts_with("<?") {
            self.until("?>", XML_INSTRUCTION, XmlPart::ProcessingInstruction);
        } else if rest.starts_with("</") {
            self.token(L_ANGLE_SLASH, self.pos + 2);
            self.tag();
        } else if rest.as_bytes().get(1).is_some_and(|&byte| is_name_start(byte)) {
            self.start_tag();
        } else {
            self.stray_character();
        }
    }

    /// Reads a comment. A comment that starts with a conflict marker comes from a merge.
    pub(super) fn comment_of_xml(&mut self) {
        if self.rest().starts_with(CONFLICT_COMMENT) {
            self.error(SyntaxErrorKind::ConflictMarker, self.pos, self.line_end(self.pos));
        }
        self.until("-->", XML_COMMENT, XmlPart::Comment);
    }

    /// Emits a token up to and including `close`, or up to the end of the text if `close` is missing.
    pub(super) fn until(&mut self, close: &str, kind: SyntaxKind, part: XmlPart) {
        match memmem::find(self.rest().as_bytes(), close.as_bytes()) {
            Some(at) => self.token(kind, self.pos + at + close.len()),
            None => {
                self.error(SyntaxErrorKind::Unterminated(part), self.pos, self.pos + 2);
                self.out.cut_off = true;
                self.token(kind, self.text.len());
            }
        }
    }

    /// Reads a CDATA section outside of code.
    fn cdata(&mut self) {
        let end = self.cdata_end();
        self.token(CDATA_OPEN, self.pos + CDATA.len());
        if end > self.pos {
            self.token(XML_TEXT, end);
        }
        self.cdata_close();
    }

    /// Returns the end of the text in the CDATA section that starts here. An unclosed section ends before the next end
    /// tag, so that it does not include the rest of the file.
    pub(super) fn cdata_end(&mut self) -> usize {
        let start = self.pos + CDATA.len();
        let body = self.text.as_bytes().part(start..);
        if !self.no_cdata_end {
            if let Some(at) = memmem::find(body, b"]]>") {
                return start + at;
            }
            self.no_cdata_end = true;
        }
        self.error(SyntaxErrorKind::Unterminated(XmlPart::CData), self.pos, start);
        let end_tag = memmem::find(body, b"</");
        self.out.cut_off |= end_tag.is_none();
        let body = self.text.part(start..start + end_tag.unwrap_or(body.len()));
        start + body.trim_end_matches([']', '>']).len()
    }

    /// Reads the end of a CDATA section, or a damaged end.
    pub(super) fn cdata_close(&mut self) {
        let mark = self.rest().bytes().take_while(|byte| matches!(byte, b']' | b'>')).count();
        let len = if self.rest().starts_with("]]>") { 3 } else { mark };
        if len > 0 {
            self.token(CDATA_CLOSE, self.pos + len);
        }
    }

    /// Reads a start tag. After `<Code>`, code follows.
    fn start_tag(&mut self) {
        self.token(L_ANGLE, self.pos + 1);
        let name_end = self.pos + self.name_len();
        let is_code = matches!(self.text.get(self.pos..name_end), Some("Code" | "code"));
        self.tag();
        if is_code && self.out.tokens.last().is_some_and(|token| token.kind == R_ANGLE) {
            self.code_content();
        }
    }

    /// Reads the inside of a tag, including its `>`. All invalid text in it is one error.
    fn tag(&mut self) {
        let faults = self.out.errors.len();
        while let Some(byte) = self.byte() {
            match byte {
                b'>' => return self.token(R_ANGLE, self.pos + 1),
                b'/' if self.rest().starts_with("/>") => return self.token(SLASH_R_ANGLE, self.pos + 2),
                b'<' if !self.take_conflict_marker() => return,
                b'<' => {}
                b' ' | b'\t' | b'\r' | b'\n' => self.blanks(),
                b'=' => self.token(XML_EQ, self.pos + 1),
                b'"' | b'\'' => self.attribute_value(byte),
                _ if self.is_after_equals_sign() => self.unquoted_value(),
                byte if is_name_start(byte) => self.token(XML_NAME, self.pos + self.name_len()),
                _ if self.out.errors.len() > faults => self.token(ERROR_TOKEN, self.pos + self.character_len()),
                _ => self.stray_character(),
            }
        }
    }

    fn is_after_equals_sign(&self) -> bool {
        self.out.tokens.last().is_some_and(|token| token.kind == XML_EQ)
    }

    /// Reads a value without quotes; the grammar reports the missing quotes.
    fn unquoted_value(&mut self) {
        let rest = self.rest();
        let ends = |next: char| matches!(next, ' ' | '\t' | '\r' | '\n' | '>' | '<' | '"' | '\'');
        let value = rest.split(ends).next().unwrap_or("");
        let at_end = rest.get(value.len()..).is_some_and(|after| after.starts_with('>'));
        let value = if at_end { value.strip_suffix('/').unwrap_or(value) } else { value };
        self.token(ERROR_TOKEN, self.pos + value.len());
    }

    fn stray_character(&mut self) {
        let end = self.pos + self.character_len();
        self.error(SyntaxErrorKind::UnexpectedText, self.pos, end);
        self.token(ERROR_TOKEN, end);
    }

    fn character_len(&self) -> usize {
        self.rest().chars().next().map_or(1, char::len_utf8)
    }

    fn name_len(&self) -> usize {
        let rest = self.rest().as_bytes();
        rest.iter().position(|&byte| !is_name_byte(byte)).unwrap_or(rest.len())
    }

    fn blanks(&mut self) {
        let rest = self.rest().as_bytes();
        let len = rest.iter().position(|byte| !is_blank(*byte)).unwrap_or(rest.len());
        self.token(WHITESPACE, self.pos + len);
    }

    /// Reads a quoted value. XML forbids `<` in it: either it was not escaped, or the closing quote is missing.
    fn attribute_value(&mut self, quote: u8) {
        let start = self.pos;
        let body = self.text.as_bytes().part(start + 1..);
        let end = match memchr2(quote, b'<', body) {
            Some(at) if body.get(at) == Some(&quote) => start + at + 2,
            Some(at) if let Some(len) = unescaped_value(body, at, quote) => {
                self.error(SyntaxErrorKind::UnexpectedText, start + 1 + at, start + 2 + at);
                start + 1 + len
            }
            other => {
                self.error(SyntaxErrorKind::Unterminated(XmlPart::AttributeValue), start, start + 1);
                start + 1 + unclosed_value(body.part(..other.unwrap_or(body.len())))
            }
        };
        self.check_entities(start, end);
        self.token(XML_STRING, end);
    }

    /// Reads character data between tags: blanks, text, entity references.
    fn character_data(&mut self) {
        if self.take_conflict_marker() {
            return;
        }
        match self.byte() {
            Some(byte) if is_blank(byte) => self.blanks(),
            Some(b'&') => match entity::resolve(self.rest()) {
                Some((_, len)) => self.token(ENTITY_REF, self.pos + len),
                None => {
                    self.unknown_entity(self.pos);
                    self.token(ERROR_TOKEN, self.pos + 1);
                }
            },
            _ => self.text(),
        }
    }

    /// Reads text up to the line end, because the next line may be a conflict marker.
    fn text(&mut self) {
        let rest = self.rest().as_bytes();
        let len = rest.iter().position(|byte| matches!(byte, b'<' | b'&' | b'\n')).unwrap_or(rest.len());
        self.token(XML_TEXT, self.pos + len.max(1));
    }

    /// Reports undefined entity references between two offsets.
    pub(super) fn check_entities(&mut self, start: usize, end: usize) {
        let mut at = start;
        while let Some(step) = memchr(b'&', self.text.as_bytes().part(at..end)) {
            at += step;
            match self.text.get(at..end).and_then(entity::resolve) {
                Some((_, len)) => at += len,
                None => {
                    self.unknown_entity(at);
                    at += 1;
                }
            }
        }
    }

    pub(super) fn unknown_entity(&mut self, at: usize) {
        let rest = self.text.part(at..);
        let bytes = rest.bytes().skip(1).take(32);
        let name = bytes.take_while(|byte| byte.is_ascii_alphanumeric() || *byte == b'#').count();
        let closed = usize::from(rest.as_bytes().get(name + 1) == Some(&b';'));
        let len = if name == 0 { 1 } else { 1 + name + closed };
        let text = rest.get(..len).unwrap_or("&").to_owned();
        self.error(SyntaxErrorKind::UnknownEntity { text }, at, at + len);
    }
}

/// Returns the length, including the closing quote, of a value with an unescaped `<` at `at`; `None` if a part of a tag
/// precedes the quote.
fn unescaped_value(body: &[u8], at: usize, quote: u8) -> Option<usize> {
    let after = body.get(at..)?;
    let len = memchr(quote, after)?;
    let is_text = !after.get(..len)?.iter().any(|byte| matches!(byte, b'>' | b'=' | b'\n'));
    is_text.then_some(at + len + 1)
}

/// Returns the end of a value without closing quote: before the end of the tag or line.
fn unclosed_value(body: &[u8]) -> usize {
    match memchr2(b'>', b'\n', body) {
        Some(at) if body.get(..at).is_some_and(|value| value.ends_with(b"/")) => at - 1,
        end => end.unwrap_or(body.len()),
    }
}

/// Start mark of a CDATA section.
pub(super) const CDATA: &str = "<![CDATA[";

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | b'\n')
}

fn is_name_start(byte: u8) -> bool {
    byte.is_ascii_alphabetic() || matches!(byte, b'_' | b':') || byte >= 0x80
}

fn is_name_byte(byte: u8) -> bool {
    is_name_start(byte) || byte.is_ascii_digit() || matches!(byte, b'-' | b'.')
}
