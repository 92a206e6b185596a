//! Code of a program: its lines and tokens in comparable form.

use std::collections::BTreeMap;
use std::ops::Range;

use rowan::NodeOrToken;
use val3_analysis::items::program;
use val3_syntax::view::{TokenView, View};
use val3_syntax::{SyntaxKind, TextSlice, decode_entities};

use crate::exclusions::BlankComparison;

/// New names of renamed programs and data, by old name.
pub(crate) type Renames = BTreeMap<String, String>;

/// Code of a program, from `begin` on.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct ProgramCode {
    lines: Vec<CodeLine>,
}

/// A line of code without its line end, decoded.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct CodeLine {
    pub(crate) text: String,
    tokens: Vec<CodeToken>,
}

/// A token that is no blank.
#[derive(Debug, Clone, PartialEq, Eq)]
struct CodeToken {
    /// Byte range in the line.
    range: Range<usize>,
    kind: TokenKind,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum TokenKind {
    /// A keyword in its canonical spelling.
    Keyword(&'static str),
    /// Name of a program, data or local variable.
    Name,
    Comment,
    /// Operators, numbers, strings, field names, and items of libraries.
    Other,
}

fn is_blank(token: &TokenView<'_>) -> bool {
    token.text().trim().is_empty()
}

impl ProgramCode {
    /// Reads the code in the tree of a `.pgx`.
    pub(crate) fn read(file: View<'_>) -> Self {
        let Some(code) = program::code(file) else { return Self::default() };
        let mut tokens = Vec::new();
        collect(code, &mut tokens);
        let is_escaped = !tokens.iter().any(|token| token.kind() == SyntaxKind::CDATA_OPEN);
        tokens.retain(|token| !matches!(token.kind(), SyntaxKind::CDATA_OPEN | SyntaxKind::CDATA_CLOSE));
        // The first line is the line of `begin`, as on the controller.
        let end = tokens.iter().rposition(|token| !is_blank(token)).map_or(0, |last| last + 1);
        let mut lines = vec![CodeLine::default()];
        let mut before = None;
        for token in tokens.iter().take(end).skip_while(|token| is_blank(token)) {
            let text = if is_escaped { decode_entities(token.text()) } else { token.text().into() };
            let kind = token.kind();
            add(&mut lines, &line_ends(&text), token_kind(kind, before));
            before = Some(kind).filter(|kind| !kind.is_trivia()).or(before);
        }
        Self { lines }
    }

    /// Returns the lines; the line of `begin` is line 1.
    pub(crate) fn lines(&self) -> &[CodeLine] {
        &self.lines
    }

    /// Returns the text with `\n` as line end.
    pub(crate) fn text(&self) -> String {
        self.lines.iter().map(|line| line.text.as_str()).collect::<Vec<_>>().join("\n")
    }

    /// Whether the statements are equal after replacing the names in this code.
    pub(crate) fn same_statements(&self, other: &Self, renames: &Renames) -> bool {
        let none = Renames::new();
        self.statements(renames).eq(other.statements(&none))
    }

    /// Whether the comments and their places between the statements are equal.
    pub(crate) fn same_comments(&self, other: &Self) -> bool {
        self.comments() == other.comments()
    }

    /// Returns the tokens without comments. Keywords are in their canonical spelling.
    pub(crate) fn statements<'c>(&'c self, renames: &'c Renames) -> impl Iterator<Item = &'c str> {
        let tokens = self.lines.iter().flat_map(|line| line.tokens.iter().map(move |token| (line, token)));
        tokens.filter(|(_, token)| token.kind != TokenKind::Comment).map(|(line, token)| line.shown(token, renames))
    }

    /// Returns the comments, each with the number of preceding tokens.
    fn comments(&self) -> Vec<(usize, &str)> {
        let mut before = 0;
        let mut comments = Vec::new();
        for (line, token) in self.lines.iter().flat_map(|line| line.tokens.iter().map(move |token| (line, token))) {
            match token.kind {
                TokenKind::Comment => comments.push((before, line.raw(token).trim_end())),
                _ => before += 1,
            }
        }
        comments
    }
}

impl CodeLine {
    /// Returns the text by which the lines in both versions are matched.
    pub(crate) fn key(&self, layout: BlankComparison, renames: &Renames) -> String {
        if layout == BlankComparison::Ignored {
            return self.tokens.iter().map(|token| self.shown(token, renames)).collect::<Vec<_>>().join(" ");
        }
        let mut key = String::with_capacity(self.text.len());
        let mut end = 0;
        for token in self.tokens.iter().filter(|token| token.kind == TokenKind::Name) {
            key.push_str(self.text.part(end..token.range.start));
            key.push_str(self.shown(token, renames));
            end = token.range.end;
        }
        key.push_str(self.text.part(end..));
        key
    }

    /// Returns the line with a placeholder for each name.
    pub(crate) fn shape(&self) -> String {
        let texts = self.tokens.iter().map(|token| match token.kind {
            TokenKind::Name => "\0",
            TokenKind::Keyword(text) => text,
            TokenKind::Comment | TokenKind::Other => self.raw(token),
        });
        texts.collect::<Vec<_>>().join(" ")
    }

    /// Returns the names of programs, data and local variables in order.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.tokens.iter().filter(|token| token.kind == TokenKind::Name).map(|token| self.raw(token))
    }

    fn raw(&self, token: &CodeToken) -> &str {
        self.text.part(token.range.clone())
    }

    fn shown<'c>(&'c self, token: &CodeToken, renames: &'c Renames) -> &'c str {
        let raw = self.raw(token);
        match token.kind {
            TokenKind::Keyword(text) => text,
            TokenKind::Name => renames.get(raw).map_or(raw, String::as_str),
            TokenKind::Comment => raw.trim_end(),
            TokenKind::Other => raw,
        }
    }
}

/// Returns the kind of a token after the non-blank token `before`; `None` for a blank.
fn token_kind(kind: SyntaxKind, before: Option<SyntaxKind>) -> Option<TokenKind> {
    match kind {
        SyntaxKind::COMMENT => Some(TokenKind::Comment),
        kind if kind.is_trivia() => None,
        SyntaxKind::IDENT if !matches!(before, Some(SyntaxKind::DOT | SyntaxKind::COLON)) => Some(TokenKind::Name),
        kind => Some(kind.keyword_text().filter(|_| kind.is_keyword()).map_or(TokenKind::Other, TokenKind::Keyword)),
    }
}

/// Adds a token, which may extend over several lines.
fn add(lines: &mut Vec<CodeLine>, text: &str, kind: Option<TokenKind>) {
    for (index, part) in text.split('\n').enumerate() {
        if index > 0 {
            lines.push(CodeLine::default());
        }
        let Some(line) = lines.last_mut().filter(|_| !part.is_empty()) else { continue };
        let start = line.text.len();
        line.text.push_str(part);
        line.tokens.extend(kind.map(|kind| CodeToken { range: start..line.text.len(), kind }));
    }
}

fn collect<'t>(node: View<'t>, found: &mut Vec<TokenView<'t>>) {
    for child in node.children_with_tokens() {
        match child {
            NodeOrToken::Node(node) => collect(node, found),
            NodeOrToken::Token(token) => found.push(token),
        }
    }
}

/// Replaces all line ends by `\n`.
pub(crate) fn line_ends(text: &str) -> String {
    text.replace("\r\n", "\n").replace('\r', "\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn code(inner: &str) -> ProgramCode {
        let text = format!("<Programs><Program name=\"p\"><Code>{inner}</Code></Program></Programs>");
        ProgramCode::read(val3_syntax::parse(&text).view())
    }

    #[test]
    fn escaped_code_is_the_same_as_cdata() {
        let new = code("<![CDATA[begin\n  if n<1 and s!=\"a\"\n  endIf\nend]]>");
        let old = code("\r\nbegin\r\n  if n&lt;1 and s!=&quot;a&quot;\r\n  endIf\r\nend\r\n   ");
        assert_eq!(new, old);
        assert!(new.text().starts_with("begin\n  if n<1") && new.text().ends_with("\nend"), "{}", new.text());
    }

    #[test]
    fn layout_and_comments_are_told_apart() {
        let none = Renames::new();
        let first = code("<![CDATA[begin\n  a=1\n  // note\nend]]>");
        let layout = code("<![CDATA[Begin\n\n    a = 1\n// note  \nEND]]>");
        assert!(first.same_statements(&layout, &none) && first.same_comments(&layout));
        let comment = code("<![CDATA[begin\n  a=1\n  // other\nend]]>");
        assert!(first.same_statements(&comment, &none) && !first.same_comments(&comment));
        assert!(!first.same_statements(&code("<![CDATA[begin\n  a=2\n  // note\nend]]>"), &none));
    }

    #[test]
    fn names_are_replaced_but_not_fields_texts_and_items_of_libraries() {
        let renames = Renames::from([("a".to_owned(), "b".to_owned())]);
        let old = code("<![CDATA[begin\n  a = p.a+lib:a // a\n  put(\"a\")\nend]]>");
        let keys = |layout| old.lines().iter().map(|line| line.key(layout, &renames)).collect::<Vec<_>>();
        assert_eq!(keys(BlankComparison::Compared)[1..3], ["  b = p.a+lib:a // a", "  put(\"a\")"]);
        assert_eq!(keys(BlankComparison::Ignored)[1], "b = p . a + lib : a // a");
    }
}
