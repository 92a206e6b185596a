//! Formatter for VAL 3 code: a tree in, edits out.
//!
//! Only whitespace, line ends and the letter case of keywords inside `<Code>` change. The XML around the code,
//! comments, and lines with syntax errors are unchanged, byte for byte.

mod indentation;
mod on_type;
mod pieces;
mod spacing;
mod style;
mod unchanged;

pub use on_type::{TRIGGERS, on_type};
pub use style::{CodeStyle, Indent, IndentOverride};

use rowan::{TextRange, TextSize};
use val3_syntax::{Parse, TextEdit, TextSlice};

use pieces::FormatToken;

/// Edits that format the code of a file with `text`, sorted and without overlap. Empty if the code is already
/// formatted.
///
/// Formatting is idempotent, and the program keeps all its tokens. If blocks do not balance, only the indentation shows
/// their intended ends, so the indentation of all lines in that program is kept. If the XML is malformed, nothing
/// changes.
pub fn format(text: &str, parse: &Parse, style: &CodeStyle) -> Vec<TextEdit> {
    if parse.errors().iter().any(|error| error.kind.breaks_structure()) {
        return Vec::new();
    }
    let mut edits: Vec<TextEdit> =
        pieces::codes(parse, text).iter().flat_map(|pieces| format_code(pieces, parse, text, style)).collect();
    edits.sort_by_key(|edit| edit.range.start());
    if unchanged::is_same_program(parse, &TextEdit::apply_all(text, &edits)) { edits } else { Vec::new() }
}

fn format_code(pieces: &[FormatToken<'_>], parse: &Parse, text: &str, style: &CodeStyle) -> Vec<TextEdit> {
    let levels = if blocks_match(pieces, parse) { indentation::levels(pieces, text) } else { vec![None; pieces.len()] };
    let pairs = pieces.iter().zip(pieces.iter().skip(1)).zip(levels.iter().skip(1));
    let gaps = pairs.filter_map(|((before, after), level)| spacing::gap(before, after, *level, text, style));
    gaps.chain(pieces.iter().filter_map(spacing::keyword)).collect()
}

/// Whether every line in the code of these pieces can be assigned to a block.
fn blocks_match(pieces: &[FormatToken<'_>], parse: &Parse) -> bool {
    let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else { return true };
    let code = TextRange::new(first.range.start(), last.range.end());
    let mut faults = parse.errors().iter().filter(|error| error.kind.is_about_blocks());
    !faults.any(|error| error.range.intersect(code).is_some())
}

/// Like [`format()`], for the lines that `range` touches. A range that ends at the start of a line does not touch it.
pub fn format_range(text: &str, parse: &Parse, style: &CodeStyle, range: TextRange) -> Vec<TextEdit> {
    let lines = whole_lines(text, range);
    let mut edits = format(text, parse, style);
    // An indentation edit includes the line end before the indentation.
    edits.retain(|edit| lines.contains_inclusive(edit.range.end()));
    edits
}

fn whole_lines(text: &str, range: TextRange) -> TextRange {
    let (start, end) = (usize::from(range.start()), usize::from(range.end()));
    let selected = text.part(start..end);
    let end = end - (selected.len() - selected.strip_suffix('\n').unwrap_or(selected).len());
    let first = text.get(..start).and_then(|before| before.rfind('\n')).map_or(0, |at| at + 1);
    let rest = text.part(end..);
    let last = end + rest.find(['\n', '\r']).unwrap_or(rest.len());
    let offset = |at: usize| TextSize::try_from(at).unwrap_or(range.end());
    TextRange::new(offset(first), offset(last))
}
