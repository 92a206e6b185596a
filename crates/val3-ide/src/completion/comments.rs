//! Documentation comments of a program and its parameters at the start of the code: `//\brief`, `//\param`.

use val3_analysis::items::parse;
use val3_syntax::SyntaxKind::{BEGIN_KW, CODE, COMMENT, NEWLINE};
use val3_syntax::{SyntaxNode, SyntaxToken, TextRange, TextSize};

use super::list::{CompletionKind as Kind, CompletionList};
use crate::assists::header_comments;

/// Range after `//` up to the cursor, if the text can begin such a comment.
pub(super) fn typed(root: &SyntaxNode, offset: TextSize) -> Option<TextRange> {
    let token = root.token_at_offset(offset).left_biased().filter(|token| token.kind() == COMMENT)?;
    let written = token.text().get(..usize::from(offset - token.text_range().start()))?;
    let typed = written.strip_prefix("//")?.trim_start_matches([' ', '\t']);
    let is_word = typed.is_empty() || typed.starts_with('\\') && !typed.contains([' ', '\t']);
    let mut before = std::iter::successors(token.prev_token(), SyntaxToken::prev_token);
    let is_first = before.find(|token| !is_blank(token)).is_some_and(|token| token.kind() == BEGIN_KW);
    (is_word && is_first).then(|| TextRange::new(offset - TextSize::of(typed), offset))
}

/// Whether the token is a comment, whitespace or a line end.
fn is_blank(token: &SyntaxToken) -> bool {
    token.kind().is_trivia() || token.kind() == NEWLINE
}

/// Completions for the comments that the program does not contain yet.
pub(super) fn complete(found: &mut CompletionList<'_>) {
    let present = present(&parse(found.db, found.file).root());
    for line in header_comments(found.db, found.project, found.file) {
        let Some(text) = line.strip_prefix("//") else { continue };
        let label = label(text);
        if !present.iter().any(|comment| comment.starts_with(&label)) {
            found.add(&label, Kind::Text).with(|item| {
                item.insert = text.to_owned();
                item.plain = text.to_owned();
            });
        }
    }
}

/// `\brief`, or `\param` with the parameter name.
fn label(text: &str) -> String {
    let words = if text.starts_with("\\param") { 2 } else { 1 };
    text.split(' ').take(words).collect::<Vec<_>>().join(" ")
}

/// Comments of the program, without their slashes.
fn present(root: &SyntaxNode) -> Vec<String> {
    let code = root.descendants().find(|node| node.kind() == CODE);
    let tokens = code.into_iter().flat_map(|code| code.descendants_with_tokens()).filter_map(|part| part.into_token());
    let comments = tokens.filter(|token| token.kind() == COMMENT);
    comments.map(|comment| comment.text().trim_start_matches(['/', ' ', '\t']).to_owned()).collect()
}
