//! Code as a sequence of pieces: its tokens without the whitespace between them.

use rowan::{NodeOrToken, TextRange};
use val3_syntax::view::{TokenView, View};
use val3_syntax::{Parse, SyntaxKind, TextSlice};

/// A token that is no whitespace.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FormatToken<'t> {
    pub(crate) kind: SyntaxKind,
    pub(crate) text: &'t str,
    pub(crate) range: TextRange,
    /// Kind of the parent node.
    pub(crate) parent: SyntaxKind,
    /// Number of blocks around it.
    pub(crate) depth: usize,
    /// Whether its line has a syntax error and is therefore kept byte for byte.
    pub(crate) frozen: bool,
}

/// Pieces of each `<Code>` in a file.
pub(crate) fn codes<'t>(parse: &'t Parse, text: &'t str) -> Vec<Vec<FormatToken<'t>>> {
    let mut codes = Vec::new();
    find_codes(parse.view(), &mut codes);
    codes.into_iter().map(|code| pieces(code, parse, text)).collect()
}

fn find_codes<'t>(node: View<'t>, codes: &mut Vec<View<'t>>) {
    for child in node.children() {
        match child.kind() {
            SyntaxKind::CODE => codes.push(child),
            SyntaxKind::ELEMENT => find_codes(child, codes),
            _ => {}
        }
    }
}

fn pieces<'t>(code: View<'t>, parse: &'t Parse, text: &str) -> Vec<FormatToken<'t>> {
    let mut pieces = Vec::new();
    collect(code, 0, &mut pieces);
    freeze(&mut pieces, parse, text);
    pieces
}

fn collect<'t>(node: View<'t>, depth: usize, pieces: &mut Vec<FormatToken<'t>>) {
    for child in node.children_with_tokens() {
        match child {
            NodeOrToken::Node(child) => {
                collect(child, depth + usize::from(is_deeper(node.kind(), child.kind())), pieces)
            }
            NodeOrToken::Token(token) => pieces.extend(piece(token, node.kind(), depth)),
        }
    }
}

/// Whether the child is indented by one level: the content of a block, and the content of a `switch` except its
/// selector.
fn is_deeper(parent: SyntaxKind, child: SyntaxKind) -> bool {
    use SyntaxKind as K;
    let is_stmt = (K::BLOCK..=K::EXPR_STMT).contains(&child);
    child == K::BLOCK || parent == K::SWITCH_STMT && is_stmt
}

fn piece(token: TokenView<'_>, parent: SyntaxKind, depth: usize) -> Option<FormatToken<'_>> {
    let kind = token.kind();
    if matches!(kind, SyntaxKind::WHITESPACE | SyntaxKind::NEWLINE) {
        return None;
    }
    let frozen = parent == SyntaxKind::ERROR || kind == SyntaxKind::ERROR_TOKEN;
    Some(FormatToken { kind, text: token.text(), range: token.range(), parent, depth, frozen })
}

/// Freezes all lines with a frozen piece or a syntax error.
fn freeze(pieces: &mut [FormatToken<'_>], parse: &Parse, text: &str) {
    for error in parse.errors().iter().filter(|error| error.kind.breaks_line()) {
        for piece in pieces.iter_mut() {
            piece.frozen |= piece.range.intersect(error.range).is_some();
        }
    }
    let mut start = 0;
    while start < pieces.len() {
        let mut end = start + 1;
        while end < pieces.len() && !breaks_line(between(pieces, end, text)) {
            end += 1;
        }
        if let Some(line) = pieces.get_mut(start..end)
            && line.iter().any(|piece| piece.frozen)
        {
            line.iter_mut().for_each(|piece| piece.frozen = true);
        }
        start = end;
    }
}

/// Whitespace before the piece at `index`.
fn between<'x>(pieces: &[FormatToken<'_>], index: usize, text: &'x str) -> &'x str {
    match pieces.get(index.wrapping_sub(1)..=index) {
        Some([before, after]) => gap(before, after, text),
        _ => "",
    }
}

/// Whitespace between two pieces.
pub(crate) fn gap<'x>(before: &FormatToken<'_>, after: &FormatToken<'_>, text: &'x str) -> &'x str {
    text.part(usize::from(before.range.end())..usize::from(after.range.start()))
}

/// Whether this whitespace contains a line end.
pub(crate) fn breaks_line(gap: &str) -> bool {
    gap.contains(['\n', '\r'])
}
