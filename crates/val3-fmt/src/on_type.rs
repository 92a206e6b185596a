//! Formatting during typing.
//!
//! The program is usually incomplete at that time, so the indentation of a line is computed only from the lines above
//! it.

use rowan::{TextRange, TextSize};
use val3_syntax::SyntaxKind::{self, *};
use val3_syntax::{Parse, TextEdit, TextSlice, text_size};

use crate::pieces::{self, FormatToken};
use crate::{CodeStyle, spacing};

/// Characters after which [`on_type`] may return edits: the line end, and the last letters of the keywords that end a
/// block or a part of a block.
pub const TRIGGERS: [char; 7] = ['\n', 'e', 'f', 'h', 'k', 'l', 'r'];

/// Edits after `typed` was inserted before `offset`. A line end formats the line above and indents the new line. The
/// last letter of a keyword such as `endIf` indents a line that contains only this keyword.
pub fn on_type(text: &str, parse: &Parse, style: &CodeStyle, offset: TextSize, typed: char) -> Vec<TextEdit> {
    let codes = pieces::codes(parse, text);
    let Some(pieces) = codes.iter().find(|pieces| contains(pieces, offset)) else { return Vec::new() };
    let lines = lines(text, pieces);
    let Some(index) = lines.iter().rposition(|line| line.start <= offset) else { return Vec::new() };
    match typed {
        '\n' => after_line_end(text, &lines, index, style),
        _ => after_letter(text, &lines, index, style, offset),
    }
}

/// A line of code.
#[derive(Debug)]
struct TypedLine<'p, 't> {
    start: TextSize,
    /// Indentation; empty if the line also contains the XML before the code.
    indent: &'t str,
    /// Tokens; empty for a blank line.
    pieces: &'p [FormatToken<'t>],
}

impl TypedLine<'_, '_> {
    /// Kind of the first token.
    fn first(&self) -> Option<SyntaxKind> {
        self.code().map(|piece| piece.kind)
    }

    fn code(&self) -> Option<&FormatToken<'_>> {
        self.pieces.iter().find(|piece| piece.kind != CDATA_OPEN)
    }

    fn starts_in_xml(&self) -> bool {
        self.pieces.first().is_some_and(|piece| piece.kind == CDATA_OPEN)
    }
}

fn contains(pieces: &[FormatToken<'_>], offset: TextSize) -> bool {
    match (pieces.first(), pieces.last()) {
        (Some(first), Some(last)) => first.range.end() <= offset && offset <= last.range.end(),
        _ => false,
    }
}

/// Lines from the first piece to the last.
fn lines<'p, 't>(text: &'t str, pieces: &'p [FormatToken<'t>]) -> Vec<TypedLine<'p, 't>> {
    let mut lines = Vec::new();
    let mut rest = pieces;
    let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else { return lines };
    let before = text.part(..usize::from(first.range.start()));
    let mut start = before.rfind('\n').map_or(0, |at| at + 1);
    while start <= usize::from(last.range.end()) {
        let line = text.get(start..).and_then(|rest| rest.split_inclusive('\n').next()).unwrap_or("");
        let end = start + line.len();
        let own = rest.partition_point(|piece| usize::from(piece.range.start()) < end);
        let (pieces, others) = rest.split_at(own);
        let blanks = line.len() - line.trim_start_matches([' ', '\t']).len();
        let indent = line.get(..blanks).filter(|_| is_first(pieces, start + blanks)).unwrap_or("");
        lines.push(TypedLine { start: text_size(start), indent, pieces });
        if line.is_empty() {
            break;
        }
        (start, rest) = (end, others);
    }
    lines
}

/// Whether only whitespace precedes the first piece of a line.
fn is_first(pieces: &[FormatToken<'_>], at: usize) -> bool {
    pieces.first().is_none_or(|piece| usize::from(piece.range.start()) == at && piece.kind != CDATA_OPEN)
}

fn after_line_end(text: &str, lines: &[TypedLine<'_, '_>], index: usize, style: &CodeStyle) -> Vec<TextEdit> {
    let Some(line) = lines.get(index) else { return Vec::new() };
    let Some(above) = index.checked_sub(1) else { return Vec::new() };
    let mut edits = Vec::new();
    let closed = lines.get(above).filter(|line| line.code().is_some());
    let moved = closed.filter(|line| line.first().is_some_and(|kind| opener(kind).is_some()));
    let indent = moved.map(|_| indentation(lines, above, style));
    edits.extend(moved.zip(indent.as_deref()).and_then(|(line, indent)| indented(text, line, indent)));
    edits.extend(closed.into_iter().flat_map(|line| within(text, line, style)));
    // The line above may have a new indentation.
    let own = match indent.filter(|_| line.first().and_then(opener).is_none()) {
        Some(moved) => below(lines.get(above), &moved, style),
        None => indentation(lines, index, style),
    };
    edits.extend(indented(text, line, &own));
    edits
}

fn after_letter(
    text: &str,
    lines: &[TypedLine<'_, '_>],
    index: usize,
    style: &CodeStyle,
    offset: TextSize,
) -> Vec<TextEdit> {
    let Some(line) = lines.get(index) else { return Vec::new() };
    let Some(word) = line.code().filter(|word| word.range.end() == offset && opener(word.kind).is_some()) else {
        return Vec::new();
    };
    // `end` is also the start of other keywords, so it is only indented after its line end.
    if line.pieces.len() > 1 || word.kind == END_KW {
        return Vec::new();
    }
    let indent = indented(text, line, &indentation(lines, index, style));
    indent.into_iter().chain(spacing::keyword(word)).collect()
}

/// Edits of whitespace and keywords within a line.
fn within(text: &str, line: &TypedLine<'_, '_>, style: &CodeStyle) -> Vec<TextEdit> {
    let pairs = line.pieces.iter().zip(line.pieces.iter().skip(1));
    let gaps = pairs.filter_map(|(before, after)| spacing::gap(before, after, None, text, style));
    let mut edits: Vec<TextEdit> = gaps.chain(line.pieces.iter().filter_map(spacing::keyword)).collect();
    edits.sort_by_key(|edit| edit.range.start());
    edits
}

/// Edit that indents a line.
fn indented(text: &str, line: &TypedLine<'_, '_>, indent: &str) -> Option<TextEdit> {
    if line.starts_in_xml() {
        return None;
    }
    let rest = text.get(usize::from(line.start)..)?;
    let found = rest.get(..rest.len() - rest.trim_start_matches([' ', '\t']).len())?;
    let range = TextRange::at(line.start, TextSize::of(found));
    (found != indent).then(|| TextEdit { range, text: indent.to_owned() })
}

/// Indentation of a line, computed from the lines above it.
fn indentation(lines: &[TypedLine<'_, '_>], index: usize, style: &CodeStyle) -> String {
    let above = lines.part(..index);
    let first = lines.get(index).and_then(TypedLine::first);
    if let Some((words, deeper)) = first.and_then(opener)
        && let Some(line) = opening(above, first, words)
    {
        return line.indent.to_owned() + &style.indent.text(deeper);
    }
    let before = above.iter().rfind(|line| line.first().is_some_and(|kind| kind != COMMENT));
    below(before, before.map_or("", |line| line.indent), style)
}

/// Indentation of a line below a line with the indentation `indent`.
fn below(line: Option<&TypedLine<'_, '_>>, indent: &str, style: &CodeStyle) -> String {
    let deeper = line.and_then(TypedLine::first).is_some_and(opens);
    indent.to_owned() + &style.indent.text(usize::from(deeper))
}

/// Line with the keyword that starts the block of `closer`.
fn opening<'l, 'p, 't>(
    above: &'l [TypedLine<'p, 't>],
    closer: Option<SyntaxKind>,
    words: &[SyntaxKind],
) -> Option<&'l TypedLine<'p, 't>> {
    let end = closer.and_then(end_of);
    let mut inner = 0usize;
    above.iter().rev().find(|line| match line.first() {
        Some(first) if Some(first) == end => {
            inner += 1;
            false
        }
        Some(first) if words.contains(&first) => match inner.checked_sub(1) {
            Some(less) => {
                inner = less;
                false
            }
            None => true,
        },
        _ => false,
    })
}

/// Keywords that start the block or part that the given keyword ends, and the number of levels by which that keyword is
/// indented further.
fn opener(kind: SyntaxKind) -> Option<(&'static [SyntaxKind], usize)> {
    Some(match kind {
        END_KW => (&[BEGIN_KW], 0),
        ELSE_KW | ELSE_IF_KW | END_IF_KW => (&[IF_KW], 0),
        END_WHILE_KW => (&[WHILE_KW], 0),
        UNTIL_KW => (&[DO_KW], 0),
        END_FOR_KW => (&[FOR_KW], 0),
        END_SWITCH_KW => (&[SWITCH_KW], 0),
        CASE_KW | DEFAULT_KW => (&[SWITCH_KW], 1),
        BREAK_KW => (&[CASE_KW, DEFAULT_KW], 0),
        _ => return None,
    })
}

/// Keyword that ends the entire block if `kind` ends a part of it.
fn end_of(kind: SyntaxKind) -> Option<SyntaxKind> {
    Some(match kind {
        ELSE_KW | ELSE_IF_KW | END_IF_KW => END_IF_KW,
        CASE_KW | DEFAULT_KW | END_SWITCH_KW => END_SWITCH_KW,
        other => other,
    })
}

/// Whether the lines after a line that starts with this keyword are indented by one level.
fn opens(kind: SyntaxKind) -> bool {
    matches!(
        kind,
        BEGIN_KW | IF_KW | ELSE_IF_KW | ELSE_KW | WHILE_KW | DO_KW | FOR_KW | SWITCH_KW | CASE_KW | DEFAULT_KW
    )
}
