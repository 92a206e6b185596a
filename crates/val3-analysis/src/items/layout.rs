//! Ranges of a program's code and comments, read from the tree on each call.

use rowan::NodeOrToken;
use val3_syntax::view::{TokenView, View};
use val3_syntax::{SyntaxKind, TextRange};

use super::{parse, program};
use crate::db::{Db, File};

/// Returns the range of the program code in `file`, from `begin` to `end`.
pub fn code(db: &dyn Db, file: File) -> Option<TextRange> {
    let parse = parse(db, file);
    let code = program::code(parse.view())?;
    let start = code.token(SyntaxKind::BEGIN_KW)?.range().start();
    let end = code.token(SyntaxKind::END_KW).map_or(code.range(), TokenView::range).end();
    Some(TextRange::new(start, end.max(start)))
}

/// Returns the comments in the program code in `file`, in order, without line ends.
pub fn comments(db: &dyn Db, file: File) -> Vec<TextRange> {
    let parse = parse(db, file);
    let mut found = Vec::new();
    if let Some(code) = program::code(parse.view()) {
        collect(code, &mut found);
    }
    found
}

fn collect(node: View<'_>, found: &mut Vec<TextRange>) {
    for child in node.children_with_tokens() {
        match child {
            NodeOrToken::Node(node) => collect(node, found),
            NodeOrToken::Token(token) if token.kind() == SyntaxKind::COMMENT => found.push(token.range()),
            NodeOrToken::Token(_) => {}
        }
    }
}
