//! What is kept of the text of a file when its tree is dropped: its faults, and where its code stands.

use rowan::NodeOrToken;
use val3_syntax::error::SyntaxError;
use val3_syntax::view::{TokenView, View};
use val3_syntax::{SyntaxKind, TextRange, TextSize};

use super::parse;
use crate::db::{Db, File};

/// The faults of a text.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct TextFaults {
    /// What the parser found, by position.
    pub errors: Vec<SyntaxError>,
    /// Keywords that are not written in their usual letter case.
    pub odd_keywords: Vec<OddKeyword>,
    /// Where code stands.
    pub codes: Vec<CodeRange>,
}

/// The code of a program: the content of its `<Code>`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CodeRange {
    /// All of it.
    pub range: TextRange,
    /// Where `begin` stands, or the code starts without one.
    pub begin: TextSize,
}

/// A keyword in another letter case than usual.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OddKeyword {
    /// Where it stands.
    pub range: TextRange,
    /// How it is usually written.
    pub canonical: &'static str,
}

/// What is wrong with the text of `file`.
#[salsa::tracked]
pub fn text_faults(db: &dyn Db, file: File) -> TextFaults {
    let parse = parse(db, file);
    let mut faults = TextFaults { errors: parse.errors().to_vec(), ..TextFaults::default() };
    codes(View::root(parse.green()), &mut faults);
    faults
}

/// Looks into the code below `node`, which is a file or an element.
fn codes(node: View<'_>, faults: &mut TextFaults) {
    for child in node.children() {
        match child.kind() {
            SyntaxKind::CODE => {
                collect(child, &mut faults.odd_keywords);
                let begin = child.token(SyntaxKind::BEGIN_KW).map_or(child.range(), |token| token.range()).start();
                faults.codes.push(CodeRange { range: child.range(), begin });
            }
            SyntaxKind::ELEMENT => codes(child, faults),
            _ => {}
        }
    }
}

fn collect(node: View<'_>, odd: &mut Vec<OddKeyword>) {
    for child in node.children_with_tokens() {
        match child {
            // Code that could not be read has a message already.
            NodeOrToken::Node(node) if node.kind() != SyntaxKind::ERROR => collect(node, odd),
            NodeOrToken::Node(_) => {}
            NodeOrToken::Token(token) => odd.extend(odd_keyword(token)),
        }
    }
}

fn odd_keyword(token: TokenView<'_>) -> Option<OddKeyword> {
    let canonical = token.kind().is_keyword().then(|| token.kind().keyword_text()).flatten()?;
    (token.text() != canonical && token.text().eq_ignore_ascii_case(canonical))
        .then(|| OddKeyword { range: token.range(), canonical })
}
