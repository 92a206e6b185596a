//! What can be folded: blocks, comments, and the XML around the code.

use rowan::NodeOrToken;
use val3_analysis::db::{Db, File};
use val3_analysis::items::parse;
use val3_syntax::view::{TokenView, View};
use val3_syntax::{SyntaxKind, TextRange};

/// Something that can be folded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fold {
    /// From the end of the line that stays to the end of what is hidden.
    pub range: TextRange,
    /// What it is.
    pub kind: FoldKind,
}

/// The kinds of folds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FoldKind {
    /// A block of code.
    Block,
    /// Lines of comment.
    Comment,
    /// XML before or behind the code, or an element of data.
    Xml,
}

/// Everything in a file that can be folded and spans more than a line.
pub fn folds(db: &dyn Db, file: File) -> Vec<Fold> {
    let text: &str = file.text(db);
    let mut folds = Vec::new();
    let root = View::root(parse(db, file).green());
    if let Some(code) = find_code(root) {
        envelope(root, code, &mut folds);
    }
    walk(root, &mut folds);
    folds.retain(|fold| text.get(std::ops::Range::<usize>::from(fold.range)).is_some_and(|text| text.contains('\n')));
    folds.sort_by_key(|fold| (fold.range.start(), fold.range.end()));
    folds
}

fn find_code(node: View<'_>) -> Option<View<'_>> {
    node.children().find_map(|child| match child.kind() {
        SyntaxKind::CODE => Some(child),
        SyntaxKind::ELEMENT => find_code(child),
        _ => None,
    })
}

/// The XML before `begin` and behind `end`, each as a whole.
fn envelope(root: View<'_>, code: View<'_>, folds: &mut Vec<Fold>) {
    let begin = code.token(SyntaxKind::BEGIN_KW).map_or(code.range().start(), |token| token.range().start());
    let end = code.token(SyntaxKind::END_KW).map_or(code.range().end(), |token| token.range().end());
    for range in [TextRange::new(root.range().start(), begin), TextRange::new(end, root.range().end())] {
        folds.push(Fold { range, kind: FoldKind::Xml });
    }
}

fn walk(node: View<'_>, folds: &mut Vec<Fold>) {
    comments(node, folds);
    for child in node.children() {
        match child.kind() {
            SyntaxKind::ELEMENT if find_code(child).is_none() => {
                folds.push(Fold { range: child.range(), kind: FoldKind::Xml });
            }
            SyntaxKind::IF_STMT
            | SyntaxKind::WHILE_STMT
            | SyntaxKind::DO_STMT
            | SyntaxKind::FOR_STMT
            | SyntaxKind::SWITCH_STMT
            | SyntaxKind::CASE_CLAUSE
            | SyntaxKind::DEFAULT_CLAUSE => folds.push(Fold { range: child.range(), kind: FoldKind::Block }),
            _ => {}
        }
        walk(child, folds);
    }
}

/// Comments in a row, with nothing but one line end between them.
fn comments(node: View<'_>, folds: &mut Vec<Fold>) {
    let mut run: Option<TextRange> = None;
    for child in node.children_with_tokens() {
        match child {
            NodeOrToken::Token(token) if token.kind() == SyntaxKind::COMMENT => {
                run = Some(run.map_or(token.range(), |run| run.cover(token.range())));
            }
            NodeOrToken::Token(token) if joins_comments(token) => {}
            _ => folds.extend(run.take().map(|range| Fold { range, kind: FoldKind::Comment })),
        }
    }
    folds.extend(run.map(|range| Fold { range, kind: FoldKind::Comment }));
}

fn joins_comments(token: TokenView<'_>) -> bool {
    match token.kind() {
        SyntaxKind::NEWLINE => token.text().matches('\n').count() <= 1,
        kind => kind == SyntaxKind::WHITESPACE,
    }
}
