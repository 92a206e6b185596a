//! Syntax faults and code ranges in a file, memoised so that the tree can be dropped.

use std::ops::Range;

use val3_syntax::characters::add_control_characters;
use val3_syntax::error::SyntaxError;
use val3_syntax::view::View;
use val3_syntax::{Parse, SyntaxKind, TextRange, TextSize, joined};

use super::parse;
use crate::db::{Db, File};

/// Syntax faults and code ranges of a file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct TextFaults {
    /// Parser errors sorted by position, one for each cause.
    pub errors: Vec<SyntaxError>,
    /// Keywords in unusual letter case.
    pub odd_keywords: Vec<OddKeyword>,
    /// Ranges of code.
    pub codes: Vec<CodeRange>,
}

/// Code of a program: the content of `<Code>`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CodeRange {
    /// Entire content.
    pub range: TextRange,
    /// Offset of `begin`, or the start of the code if `begin` is missing.
    pub begin: TextSize,
}

/// A keyword in unusual letter case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OddKeyword {
    /// Range of the keyword.
    pub range: TextRange,
    /// Usual spelling.
    pub canonical: &'static str,
}

/// Returns the syntax faults of `file`.
#[salsa::tracked]
pub fn text_faults(db: &dyn Db, file: File) -> TextFaults {
    let parse = parse(db, file);
    let mut errors = joined(file.text(db), parse.errors());
    add_control_characters(file.text(db), &mut errors);
    let mut faults = TextFaults { errors, ..TextFaults::default() };
    codes(parse.view(), &mut faults.codes);
    faults.odd_keywords = odd_keywords(&parse, file.text(db));
    faults
}

/// Collects the code below `node`, which is a file or an element.
fn codes(node: View<'_>, found: &mut Vec<CodeRange>) {
    for child in node.children() {
        match child.kind() {
            SyntaxKind::CODE => {
                let begin = child.token(SyntaxKind::BEGIN_KW).map_or(child.range(), |token| token.range()).start();
                found.push(CodeRange { range: child.range(), begin });
            }
            SyntaxKind::ELEMENT => codes(child, found),
            _ => {}
        }
    }
}

fn odd_keywords(parse: &Parse, text: &str) -> Vec<OddKeyword> {
    let odd = parse.odd_keywords();
    if odd.is_empty() {
        return Vec::new();
    }
    // Unparsed code has already been reported.
    let mut unread = Vec::new();
    unread_code(parse.view(), &mut unread);
    let canonical = |range: TextRange| SyntaxKind::from_keyword(text.get(Range::<usize>::from(range))?)?.keyword_text();
    odd.iter()
        .filter(|range| !is_in_any(&unread, **range))
        .filter_map(|range| Some(OddKeyword { range: *range, canonical: canonical(*range)? }))
        .collect()
}

/// Whether one of `ranges` contains `range`. They are sorted and do not overlap.
fn is_in_any(ranges: &[TextRange], range: TextRange) -> bool {
    let next = ranges.partition_point(|earlier| earlier.end() < range.end());
    ranges.get(next).is_some_and(|next| next.contains_range(range))
}

/// Collects the outermost error nodes in source order.
fn unread_code(node: View<'_>, found: &mut Vec<TextRange>) {
    match node.kind() {
        SyntaxKind::ERROR => found.push(node.range()),
        _ => node.children().for_each(|child| unread_code(child, found)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keywords_in_faulty_code_are_not_reported() {
        let text = "<Code><![CDATA[begin\nWhile x\n  y=1 Call To\nENDWHILE\ny=)Else\nRETURN\nend]]></Code>";
        let odd = odd_keywords(&val3_syntax::parse(text), text);
        let words: Vec<&str> = odd.iter().map(|odd| &text[Range::<usize>::from(odd.range)]).collect();
        assert_eq!(words, ["While", "ENDWHILE", "RETURN"]);
        assert_eq!(odd[1].canonical, "endWhile");
    }
}
