//! Check that formatting changes nothing but whitespace and the letter case of keywords.

use rowan::NodeOrToken;
use val3_syntax::view::View;
use val3_syntax::{Parse, SyntaxKind, parse};

/// Whether the text after the edits has the same tokens and syntax errors as before, except for whitespace and the
/// letter case of keywords.
pub(crate) fn is_same_program(before: &Parse, after: &str) -> bool {
    let after = parse(after);
    let kinds = |parse: &Parse| parse.errors().iter().map(|error| error.kind.clone()).collect::<Vec<_>>();
    kinds(before) == kinds(&after) && tokens(before) == tokens(&after)
}

fn tokens(parse: &Parse) -> Vec<(SyntaxKind, &str)> {
    let mut tokens = Vec::new();
    collect(parse.view(), &mut tokens);
    tokens
}

fn collect<'t>(node: View<'t>, tokens: &mut Vec<(SyntaxKind, &'t str)>) {
    for child in node.children_with_tokens() {
        match child {
            NodeOrToken::Node(child) => collect(child, tokens),
            NodeOrToken::Token(token) => match token.kind() {
                SyntaxKind::WHITESPACE | SyntaxKind::NEWLINE => {}
                kind => tokens.push((kind, kind.keyword_text().unwrap_or(token.text()))),
            },
        }
    }
}
