//! Growing a selection: word, expression, statement, block, element, file.

use val3_analysis::db::Db;
use val3_analysis::items::parse;
use val3_syntax::{SyntaxKind, TextRange};

use crate::FilePosition;

/// The ranges around a position, from the innermost on; each holds the one before.
pub fn selections(db: &dyn Db, at: FilePosition) -> Vec<TextRange> {
    let root = parse(db, at.file).root();
    if !root.text_range().contains_inclusive(at.offset) {
        return Vec::new();
    }
    let Some(token) = root.token_at_offset(at.offset).right_biased() else { return vec![root.text_range()] };
    let mut ranges = vec![token.text_range()];
    if token.kind() == SyntaxKind::XML_STRING || token.kind() == SyntaxKind::STRING {
        ranges.insert(0, within_quotes(token.text_range(), token.text()));
    }
    ranges.extend(token.parent_ancestors().map(|node| node.text_range()));
    ranges.dedup();
    ranges
}

/// The text between the quotes, which may be written as character references.
fn within_quotes(range: TextRange, text: &str) -> TextRange {
    let quote = if text.starts_with("&quot;") { 6u32 } else { 1 };
    let closed = text.len() > 1 && (text.ends_with(['"', '\'']) || text.ends_with("&quot;"));
    let start = range.start() + rowan::TextSize::new(quote.min(u32::from(range.len())));
    let end = if closed { range.end() - rowan::TextSize::new(quote) } else { range.end() };
    if start <= end { TextRange::new(start, end) } else { range }
}
