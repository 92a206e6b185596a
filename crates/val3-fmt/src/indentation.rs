//! Indentation level of each line.

use val3_syntax::SyntaxKind::{self, *};

use crate::pieces::{FormatToken, breaks_line, gap};

/// Level of the line that each piece starts; `None` for a piece that starts no line.
pub(crate) fn levels(pieces: &[FormatToken<'_>], text: &str) -> Vec<Option<usize>> {
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
            // A frozen line is no reference for the indentation of other lines.
            next = Some(IndentedLine { level, column, closes: closes(piece.kind) && !piece.frozen });
        }
    }
    levels
}

/// The next line of code.
#[derive(Clone, Copy)]
struct IndentedLine {
    level: usize,
    /// Indentation width in the original text.
    column: usize,
    /// Whether it ends a block or a part of a block.
    closes: bool,
}

/// Level of a comment: usually the level of the next line. Before the end of a block, the comment's own indentation
/// shows whether it belongs to the block or to the closing line. In indented code, a comment in the first column
/// remains there, because it is usually disabled code with its own spaces after the slashes.
fn comment(piece: &FormatToken<'_>, column: usize, next: Option<IndentedLine>) -> usize {
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

/// Width of the whitespace after the last line end.
fn width(blanks: &str) -> usize {
    blanks.rsplit(['\n', '\r']).next().unwrap_or("").chars().count()
}
