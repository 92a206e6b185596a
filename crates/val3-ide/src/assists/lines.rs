//! Moving lines of code to another position.

use std::borrow::Cow;

use rowan::NodeOrToken;
use val3_syntax::ast::{AstNode as _, Block, Code};
use val3_syntax::{SyntaxKind, SyntaxNode, SyntaxToken, TextRange, TextSize, TextSlice, decode_entities, text_size};

use super::context::Context;

/// Lines of a block with the comments around its statements, each preceded by a line end and `indent`. Relative
/// indentation is kept.
pub(super) fn relaid(context: &Context<'_>, block: &Block, indent: &str) -> String {
    let range = with_comments(block);
    if range.is_empty() {
        return String::new();
    }
    let line_end = context.line_end();
    let lines = dedented(context.text, range);
    let indented = lines.into_iter().map(|line| match line.is_empty() {
        true => line_end.to_owned(),
        false => format!("{line_end}{indent}{line}"),
    });
    indented.collect()
}

/// Lines of a range, without line ends and without their common indentation.
pub(super) fn dedented(text: &str, range: TextRange) -> Vec<String> {
    let start =
        text.get(..usize::from(range.start())).and_then(|before| before.rfind(['\n', '\r'])).map_or(0, |at| at + 1);
    let whole = text.part(start..usize::from(range.end()));
    let first = text.part(start..usize::from(range.start()));
    // If XML precedes the first line, that line starts with the code.
    let whole = if first.trim().is_empty() { whole } else { whole.part(first.len()..) };
    let lines: Vec<&str> = whole.lines().map(|line| line.strip_suffix("&#13;").unwrap_or(line)).collect();
    let blanks = |line: &&str| line.len() - line.trim_start_matches([' ', '\t']).len();
    let common = lines.iter().filter(|line| !line.trim().is_empty()).map(blanks).min().unwrap_or(0);
    lines.iter().map(|line| line.get(common..).unwrap_or("").trim_end().to_owned()).collect()
}

/// Range from the first to the last comment or statement of a block. In the tree, comments at the ends of a block are
/// its siblings.
pub(super) fn with_comments(block: &Block) -> TextRange {
    let own = block.syntax().text_range();
    let before = block.syntax().prev_sibling_or_token().and_then(|it| match it {
        NodeOrToken::Node(node) => node.last_token(),
        NodeOrToken::Token(token) => Some(token),
    });
    let head = std::iter::successors(before, previous).find(|token| !belongs_to(own, token));
    let behind = std::iter::successors(head.as_ref().and_then(next), next);
    let content = behind.take_while(|token| belongs_to(own, token)).filter(|token| !is_whitespace(token));
    let ranges = content.map(|token| token.text_range());
    ranges.reduce(TextRange::cover).unwrap_or(TextRange::empty(own.start()))
}

/// Whether the token is inside the block, or is a comment or whitespace.
fn belongs_to(block: TextRange, token: &SyntaxToken) -> bool {
    let inside = block.contains_range(token.text_range()) && !block.is_empty();
    inside || is_whitespace(token) || token.kind() == SyntaxKind::COMMENT
}

/// Whether the token is whitespace or a line end.
fn is_whitespace(token: &SyntaxToken) -> bool {
    matches!(token.kind(), SyntaxKind::WHITESPACE | SyntaxKind::NEWLINE)
}

/// Complete lines of a range, with their line ends; `None` if the lines contain anything else.
pub(super) fn whole_lines(context: &Context<'_>, range: TextRange) -> Option<TextRange> {
    let before = context.text.get(..usize::from(range.start()))?;
    let start = before.rfind(['\n', '\r']).map_or(0, |at| at + 1);
    let end = end_of_line(context, range.end())?;
    let is_alone = before.get(start..)?.trim().is_empty();
    is_alone.then_some(TextRange::new(TextSize::try_from(start).ok()?, end))
}

/// Start of the next line; `None` if anything other than whitespace precedes it.
pub(super) fn end_of_line(context: &Context<'_>, at: TextSize) -> Option<TextSize> {
    let rest = context.text.get(usize::from(at)..)?;
    let end = rest.find('\n')? + 1;
    is_blank(rest.get(..end)?).then(|| at + text_size(end))
}

/// Whether the line contains only whitespace.
pub(super) fn is_blank(line: &str) -> bool {
    let line = line.trim_end();
    line.strip_suffix("&#13;").unwrap_or(line).trim().is_empty()
}

/// Previous token. rowan's `prev_token` stops at an empty block.
fn previous(token: &SyntaxToken) -> Option<SyntaxToken> {
    let start = token.text_range().start();
    let root = token.parent_ancestors().last()?;
    root.token_at_offset(start).left_biased().filter(|found| found.text_range().end() <= start)
}

/// Next token. rowan's `next_token` stops at an empty block.
fn next(token: &SyntaxToken) -> Option<SyntaxToken> {
    let end = token.text_range().end();
    let root = token.parent_ancestors().last()?;
    root.token_at_offset(end).right_biased().filter(|found| found.text_range().start() >= end)
}

/// Ranges of the comments that are direct children of a node.
pub(super) fn own_comments(node: &SyntaxNode) -> Vec<TextRange> {
    let tokens = node.children_with_tokens().filter_map(NodeOrToken::into_token);
    tokens.filter(|token| token.kind() == SyntaxKind::COMMENT).map(|token| token.text_range()).collect()
}

/// Whether the code is outside a CDATA section, so that some characters are escaped.
pub(super) fn is_escaped(code: &Code) -> bool {
    !code.syntax().children_with_tokens().any(|it| it.kind() == SyntaxKind::CDATA_OPEN)
}

/// A part of code, unescaped, with the sorted ranges `places` replaced by other texts.
pub(super) fn plain_with(code: &Code, text: &str, range: TextRange, places: &[(TextRange, &str)]) -> String {
    let escaped = is_escaped(code);
    let mut new = String::new();
    let mut done = usize::from(range.start());
    for (place, other) in places {
        new += &plain(text.part(done..usize::from(place.start())), escaped);
        new += other;
        done = usize::from(place.end());
    }
    new + &plain(text.part(done..usize::from(range.end())), escaped)
}

/// Code without escapes.
fn plain(code: &str, is_escaped: bool) -> Cow<'_, str> {
    if is_escaped { decode_entities(code) } else { Cow::Borrowed(code) }
}
