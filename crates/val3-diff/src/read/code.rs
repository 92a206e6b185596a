//! The code of a program: its lines, and its tokens in comparable form.

use rowan::NodeOrToken;
use val3_analysis::items::program;
use val3_syntax::view::{TokenView, View};
use val3_syntax::{SyntaxKind, decode_entities};

/// The code of a program.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Code {
    /// The text from `begin` on, decoded, with `\n` as line end.
    pub(crate) text: String,
    /// The tokens without blanks and comments. Keywords have their usual letters.
    statements: Vec<String>,
    /// The comments, each with the number of tokens before it.
    comments: Vec<(usize, String)>,
}

impl Code {
    /// Reads the code in the tree of a `.pgx`. `source` is the text of the file.
    pub(crate) fn read(file: View<'_>, source: &str) -> Self {
        let Some(code) = program::code(file) else { return Self::default() };
        let mut tokens = Vec::new();
        collect(code, &mut tokens);
        let is_escaped = !tokens.iter().any(|token| token.kind() == SyntaxKind::CDATA_OPEN);
        let decoded = |text: &str| if is_escaped { decode_entities(text).into_owned() } else { text.to_owned() };
        let mut read = Self { text: lines(&decoded(content(&tokens, source))), ..Self::default() };
        for token in tokens {
            match token.kind() {
                SyntaxKind::COMMENT => read.comments.push((read.statements.len(), decoded(token.text().trim_end()))),
                kind if kind.is_trivia() => {}
                kind if kind.is_keyword() => read.statements.push(kind.keyword_text().unwrap_or("").to_owned()),
                _ => read.statements.push(decoded(token.text())),
            }
        }
        read
    }

    /// The statements of both are the same.
    pub(crate) fn same_statements(&self, other: &Self) -> bool {
        self.statements == other.statements
    }

    /// Both have the same comments at the same statements.
    pub(crate) fn same_comments(&self, other: &Self) -> bool {
        self.comments == other.comments
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

/// The text of the code without the brackets of CDATA. It starts at `begin`, the line that the controller counts first.
fn content<'s>(tokens: &[TokenView<'_>], source: &'s str) -> &'s str {
    let is_bracket = |token: &&TokenView<'_>| matches!(token.kind(), SyntaxKind::CDATA_OPEN | SyntaxKind::CDATA_CLOSE);
    let inner = || tokens.iter().filter(|token| !is_bracket(token));
    let is_blank = |token: &&TokenView<'_>| token.text().trim().is_empty();
    let first = inner().find(|token| !is_blank(token)).map(|token| token.range().start());
    let last = inner().rfind(|token| !is_blank(token)).map(|token| token.range().end());
    let (Some(first), Some(last)) = (first, last) else { return "" };
    source.get(usize::from(first)..usize::from(last)).unwrap_or("")
}

/// The text with `\n` as line end.
pub(crate) fn lines(text: &str) -> String {
    text.replace("\r\n", "\n").replace('\r', "\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn code(inner: &str) -> Code {
        let text = format!("<Programs><Program name=\"p\"><Code>{inner}</Code></Program></Programs>");
        Code::read(val3_syntax::parse(&text).view(), &text)
    }

    #[test]
    fn escaped_code_is_the_same_as_cdata() {
        let new = code("<![CDATA[begin\n  if n<1 and s!=\"a\"\n  endIf\nend]]>");
        let old = code("\r\nbegin\r\n  if n&lt;1 and s!=&quot;a&quot;\r\n  endIf\r\nend\r\n   ");
        assert_eq!(new, old);
        assert!(new.text.starts_with("begin\n  if n<1") && new.text.ends_with("\nend"), "{}", new.text);
    }

    #[test]
    fn layout_and_comments_are_told_apart() {
        let first = code("<![CDATA[begin\n  a=1\n  // note\nend]]>");
        let layout = code("<![CDATA[Begin\n\n    a = 1\n// note  \nEND]]>");
        assert!(first.same_statements(&layout) && first.same_comments(&layout));
        let comment = code("<![CDATA[begin\n  a=1\n  // other\nend]]>");
        assert!(first.same_statements(&comment) && !first.same_comments(&comment));
        assert!(!first.same_statements(&code("<![CDATA[begin\n  a=2\n  // note\nend]]>")));
    }
}
