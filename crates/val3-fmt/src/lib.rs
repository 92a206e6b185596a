//! Layout of VAL 3 code: a tree in, edits out.
//!
//! Only blanks, line ends and the letter case of keywords inside of `<Code>` change. The XML around the code,
//! comments, and lines that could not be read stay as they are, to the byte.

mod indentation;
mod pieces;
mod spacing;
mod style;
mod unchanged;

pub use style::{Indent, Style};

use rowan::TextRange;
use val3_syntax::Parse;

use pieces::Piece;

/// A change of the text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edit {
    /// What is replaced; empty where something is put in.
    pub range: TextRange,
    /// What stands there afterwards.
    pub text: String,
}

/// The edits that give the code of a file with `text` its layout, in order and without overlap; none where it has it already,
/// or where its blocks do not match up.
///
/// Formatting twice is formatting once, and the program stays the same, token for token.
pub fn format(text: &str, parse: &Parse, style: &Style) -> Vec<Edit> {
    if parse.errors().iter().any(|error| error.kind.is_about_blocks() || error.kind.breaks_structure()) {
        return Vec::new();
    }
    let mut edits: Vec<Edit> =
        pieces::codes(parse, text).iter().flat_map(|pieces| format_code(pieces, text, style)).collect();
    edits.sort_by_key(|edit| edit.range.start());
    if unchanged::is_same_program(parse, &apply(text, &edits)) { edits } else { Vec::new() }
}

fn format_code(pieces: &[Piece<'_>], text: &str, style: &Style) -> Vec<Edit> {
    let levels = indentation::levels(pieces, text);
    let pairs = pieces.iter().zip(pieces.iter().skip(1)).zip(levels.iter().skip(1));
    let gaps = pairs.filter_map(|((before, after), level)| spacing::gap(before, after, *level, text, style));
    gaps.chain(pieces.iter().filter_map(spacing::keyword)).collect()
}

/// As [`format`], for the lines that `range` touches.
pub fn format_range(text: &str, parse: &Parse, style: &Style, range: TextRange) -> Vec<Edit> {
    let mut edits = format(text, parse, style);
    edits.retain(|edit| edit.range.intersect(range).is_some());
    edits
}

/// The text with the edits made. They must be in order and lie within it.
pub fn apply(text: &str, edits: &[Edit]) -> String {
    let mut changed = String::with_capacity(text.len());
    let mut done = 0;
    for edit in edits {
        let (start, end) = (usize::from(edit.range.start()), usize::from(edit.range.end()));
        changed.push_str(text.get(done..start).unwrap_or(""));
        changed.push_str(&edit.text);
        done = end;
    }
    changed.push_str(text.get(done..).unwrap_or(""));
    changed
}
