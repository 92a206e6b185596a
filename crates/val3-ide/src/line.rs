//! The line of code at the cursor, as tokens.
//!
//! A line is usually incomplete while it is typed. The tokens before the cursor do not depend on the text after it, so
//! completion and signature help read tokens instead of the syntax tree.

mod blocks;
mod bracket;
mod call;
mod expected;
mod token_types;

pub(crate) use blocks::{Block, CodePart, code_part, open_blocks};
pub(crate) use bracket::Bracket;
pub(crate) use call::{CallSite, Callee, takes_program};
pub(crate) use expected::{Expected, ends_value, expected};
pub(crate) use token_types::VisibleNames;

use rowan::TokenAtOffset;
use val3_syntax::SyntaxKind::{self, *};
use val3_syntax::{SyntaxNode, SyntaxToken, TextRange, TextSize, TextSlice, text_at, text_size};

/// Tokens in a code line, without trivia.
#[derive(Debug, Clone)]
pub(crate) struct LineTokens {
    tokens: Vec<SyntaxToken>,
    /// Number of tokens that end before the cursor, not counting a word or string that touches it.
    before: usize,
    /// Word, number or string at or directly before the cursor; it follows the first `before` tokens.
    current: Option<SyntaxToken>,
}

impl LineTokens {
    /// Line that contains `offset`; `None` outside code and in a comment.
    pub(crate) fn around(root: &SyntaxNode, offset: TextSize) -> Option<Self> {
        if !root.text_range().contains_inclusive(offset) {
            return None;
        }
        let (left, right) = match root.token_at_offset(offset) {
            TokenAtOffset::None => return None,
            TokenAtOffset::Single(token) => (token.clone(), token),
            TokenAtOffset::Between(left, right) => (left, right),
        };
        let code = left.parent_ancestors().find(|node| node.kind() == CODE)?;
        if left.kind() == COMMENT || !holds_statements(&code, offset) {
            return None;
        }
        let current = touches_cursor(left.kind()).then(|| left.clone());
        let mut tokens = before(&left, offset, current.is_some());
        let before = tokens.len();
        tokens.extend(current.clone());
        tokens.extend(after(&right, offset, current.as_ref()));
        Some(Self { tokens, before, current })
    }

    /// Tokens before the cursor, without the word or string that contains it.
    pub(crate) fn before(&self) -> &[SyntaxToken] {
        self.tokens.part(..self.before)
    }

    /// All tokens of the line.
    pub(crate) fn tokens(&self) -> &[SyntaxToken] {
        &self.tokens
    }

    /// Word, number or string at or directly before the cursor.
    pub(crate) fn current(&self) -> Option<&SyntaxToken> {
        self.current.as_ref()
    }
}

/// Whether the cursor is after `begin` and before `end`, if these exist.
fn holds_statements(code: &SyntaxNode, offset: TextSize) -> bool {
    first_token(code, BEGIN_KW).is_none_or(|begin| begin.end() < offset)
        && first_token(code, END_KW).is_none_or(|end| offset <= end.end())
}

/// Range of the first token of this kind among the node's children.
fn first_token(node: &SyntaxNode, kind: SyntaxKind) -> Option<TextRange> {
    let mut tokens = node.children_with_tokens().filter_map(|child| child.into_token());
    tokens.find(|token| token.kind() == kind).map(|token| token.text_range())
}

fn touches_cursor(kind: SyntaxKind) -> bool {
    matches!(kind, IDENT | NUMBER | STRING) || kind.is_keyword()
}

fn ends_line(kind: SyntaxKind) -> bool {
    matches!(kind, NEWLINE | CDATA_OPEN | CDATA_CLOSE | BEGIN_KW) || (L_ANGLE..=ENTITY_REF).contains(&kind)
}

fn before(left: &SyntaxToken, offset: TextSize, skip: bool) -> Vec<SyntaxToken> {
    // The cursor is in or after a line end, or inside any other token.
    let whole = left.text_range().end() <= offset && !skip;
    let first = if whole { Some(left.clone()) } else { left.prev_token() };
    if left.kind() == NEWLINE {
        return Vec::new();
    }
    let tokens = std::iter::successors(first, SyntaxToken::prev_token);
    let mut tokens: Vec<SyntaxToken> =
        tokens.take_while(|token| !ends_line(token.kind())).filter(|token| !token.kind().is_trivia()).collect();
    tokens.reverse();
    tokens
}

fn after(right: &SyntaxToken, offset: TextSize, current: Option<&SyntaxToken>) -> Vec<SyntaxToken> {
    let mut first = if Some(right) == current { right.next_token() } else { Some(right.clone()) };
    if right.kind() == NEWLINE && right.text_range().start() < offset {
        let rest = right.text().part(usize::from(offset - right.text_range().start())..);
        first = if rest.contains(['\n', '\r']) { None } else { right.next_token() };
    }
    let tokens = std::iter::successors(first, SyntaxToken::next_token);
    tokens.take_while(|token| !ends_line(token.kind())).filter(|token| !token.kind().is_trivia()).collect()
}

/// Length in bytes of the quote at the start of a string, which may be an escaped quote.
fn quote(text: &str) -> u32 {
    match text.strip_prefix('&').and_then(|rest| rest.find(';')) {
        Some(end) => u32::try_from(end + 2).unwrap_or(0),
        None => 1,
    }
}

/// Range of a string without its quotes.
pub(crate) fn inside(string: &SyntaxToken) -> TextRange {
    let (range, text) = (string.text_range(), string.text());
    let open = quote(text).min(u32::from(range.len()));
    let rest = text.part(open as usize..);
    let close = match rest.rfind('&').filter(|_| rest.ends_with(';')) {
        Some(at) if val3_syntax::resolve_entity(rest.part(at..)).is_some_and(|(found, _)| found == '"') => {
            rest.len() - at
        }
        _ => usize::from(rest.ends_with('"')),
    };
    let start = range.start() + TextSize::new(open);
    let end = range.end() - text_size(close);
    TextRange::new(start, end.max(start))
}

/// Text of a string with entities decoded.
pub(crate) fn string_text(string: &SyntaxToken) -> String {
    let inside = inside(string) - string.text_range().start();
    let raw = text_at(string.text(), inside);
    if string.text().starts_with('&') { val3_syntax::decode_entities(raw).into_owned() } else { raw.to_owned() }
}

/// Index of the innermost bracket that is still open at the end of `tokens`.
fn open_bracket(tokens: &[SyntaxToken]) -> Option<usize> {
    let mut closed = 0usize;
    tokens.iter().enumerate().rev().find_map(|(index, token)| match token.kind() {
        R_PAREN | R_BRACK | R_CURLY => {
            closed += 1;
            None
        }
        L_PAREN | L_BRACK | L_CURLY if closed == 0 => Some(index),
        L_PAREN | L_BRACK | L_CURLY => {
            closed -= 1;
            None
        }
        _ => None,
    })
}

/// Parts between top-level commas, up to a closing bracket without an opening one.
fn pieces(tokens: &[SyntaxToken]) -> Vec<&[SyntaxToken]> {
    let (mut depth, mut start, mut end) = (0usize, 0, tokens.len());
    let mut found = Vec::new();
    for (index, token) in tokens.iter().enumerate() {
        match token.kind() {
            L_PAREN | L_BRACK | L_CURLY => depth += 1,
            R_PAREN | R_BRACK | R_CURLY if depth == 0 => {
                end = index;
                break;
            }
            R_PAREN | R_BRACK | R_CURLY => depth -= 1,
            COMMA if depth == 0 => {
                found.extend(tokens.get(start..index));
                start = index + 1;
            }
            _ => {}
        }
    }
    found.extend(tokens.get(start..end));
    found
}
