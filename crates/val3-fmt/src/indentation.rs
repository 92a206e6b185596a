//! The indentation level of each line.

use val3_syntax::SyntaxKind::{self, *};

use crate::pieces::{Piece, breaks_line, gap};

/// The level of the line that each piece starts; `None` for a piece that starts no line.
pub(crate) fn levels(pieces: &[Piece<'_>], text: &str) -> Vec<Option<usize>> {
    let mut levels = vec![None; pieces.len()];
    // The level of a comment depends on the next line, so the lines are visited from the last to the first.
    let mut next: Option<IndentedLine> = None;
    for index in (1..pieces.len()).rev() {
        let Some([before, piece]) = pieces.get(index - 1..=index) else { continue };
        let blanks = gap(before, piece, text);
        if !breaks_line(blanks) {
            continue;
        }
        let column = width(blanks);
        let level = if piece.kind == COMMENT { comment(piece, column, next) } else { piece.depth };
        if let Some(slot) = levels.get_mut(index) {
            *slot = Some(level);
        }
        if piece.kind != COMMENT {
            // A line that does not move is no guide for the lines that do.
            next = Some(IndentedLine { level, column, closes: closes(piece.kind) && !piece.frozen });
        }
    }
    levels
}

/// The line of code that follows.
#[derive(Clone, Copy)]
struct IndentedLine {
    level: usize,
    /// The blanks before it in the text.
    column: usize,
    /// It ends a block or a part of one.
    closes: bool,
}

/// The level of a comment: that of the next line. Before the end of a block its own indentation shows whether it
/// belongs to the block or to the line that ends it. A comment in the first column remains there if the code is
/// indented: it is usually disabled code, which keeps its own blanks after the slashes.
fn comment(piece: &Piece<'_>, column: usize, next: Option<IndentedLine>) -> usize {
    match next {
        Some(next) if column == 0 && next.column > 0 => 0,
        Some(next) if next.closes && column > next.column => next.level + 1,
        Some(next) => next.level,
        None => piece.depth,
    }
}

fn closes(kind: SyntaxKind) -> bool {
    matches!(
        kind,
        END_KW | END_IF_KW | ELSE_IF_KW | ELSE_KW | END_WHILE_KW | UNTIL_KW | END_FOR_KW | END_SWITCH_KW | BREAK_KW
    )
}

/// The width of the blanks after the last line end.
fn width(blanks: &str) -> usize {
    blanks.rsplit(['\n', '\r']).next().unwrap_or("").chars().count()
}
