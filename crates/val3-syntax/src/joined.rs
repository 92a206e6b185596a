//! Joins errors with a common cause.
//!
//! The parser reports each error at its position. Some mistakes cause two or more errors. They are joined in the
//! complete list of errors, so that a part of a file can be parsed separately.

use std::ops::Range;

use rowan::{TextRange, TextSize};

use crate::error::{SyntaxError, SyntaxErrorKind};
use crate::kind::SyntaxKind::{self, *};

/// Joins the parser's `errors`, so that each cause is reported once.
pub fn joined(text: &str, errors: &[SyntaxError]) -> Vec<SyntaxError> {
    let errors = without_rest_of_section(text, errors);
    let errors = join_neighbours(errors, is_about_body, begin_and_end);
    let errors = join_neighbours(errors, is_about_ends, do_while);
    join_neighbours(errors, is_about_ends, |first, second| crossed_blocks(text, first, second))
}

/// Joins pairs of consecutive errors among the `relevant` ones.
fn join_neighbours(
    errors: Vec<SyntaxError>,
    relevant: fn(&SyntaxErrorKind) -> bool,
    join: impl Fn(&SyntaxError, &SyntaxError) -> Option<SyntaxError>,
) -> Vec<SyntaxError> {
    let mut found: Vec<SyntaxError> = Vec::with_capacity(errors.len());
    let mut last = None;
    for error in errors {
        if relevant(&error.kind) {
            let first = last.and_then(|at: usize| found.get_mut(at));
            if let Some((first, whole)) = first.and_then(|first| join(first, &error).map(|whole| (first, whole))) {
                *first = whole;
                last = None;
                continue;
            }
            last = Some(found.len());
        }
        found.push(error);
    }
    found
}

fn is_about_body(kind: &SyntaxErrorKind) -> bool {
    matches!(kind, SyntaxErrorKind::MissingBegin | SyntaxErrorKind::MissingEnd)
}

fn begin_and_end(first: &SyntaxError, second: &SyntaxError) -> Option<SyntaxError> {
    let both = (&first.kind, &second.kind) == (&SyntaxErrorKind::MissingBegin, &SyntaxErrorKind::MissingEnd);
    let kind = SyntaxErrorKind::MissingBeginAndEnd;
    both.then_some(SyntaxError { kind, range: first.range, related: Some(second.range) })
}

fn is_about_ends(kind: &SyntaxErrorKind) -> bool {
    matches!(kind, SyntaxErrorKind::UnclosedBlock { .. } | SyntaxErrorKind::UnmatchedBlockEnd { .. })
}

/// Joins a `do` without `until` and a later `while` without `endWhile`.
fn do_while(first: &SyntaxError, second: &SyntaxError) -> Option<SyntaxError> {
    let opened = opener("do", first).or_else(|| opener("do", second))?;
    let ended = opener("while", first).or_else(|| opener("while", second))?;
    let is_end = opened.end() < ended.start();
    is_end.then_some(SyntaxError { kind: SyntaxErrorKind::DoWhile, range: ended, related: Some(opened) })
}

/// Keyword that opens a block of this kind without an end.
fn opener(name: &str, error: &SyntaxError) -> Option<TextRange> {
    let is_open = matches!(error.kind, SyntaxErrorKind::UnclosedBlock { block, .. } if block == name);
    error.related.filter(|_| is_open)
}

/// Joins an inner block that ends at the end of an outer block, and the end of the inner block.
fn crossed_blocks(text: &str, first: &SyntaxError, second: &SyntaxError) -> Option<SyntaxError> {
    let SyntaxErrorKind::UnclosedBlock { block: inner, missing: late } = first.kind else { return None };
    let early = block_end(text, first.range)?;
    let is_crossed = match second.kind {
        SyntaxErrorKind::UnmatchedBlockEnd { found, .. } => found == late,
        SyntaxErrorKind::UnclosedBlock { missing, .. } => missing == early,
        _ => false,
    };
    let is_other = early != late && block_end(text, second.range) == Some(late);
    let kind = SyntaxErrorKind::CrossedBlocks { inner, early, late };
    (is_crossed && is_other).then_some(SyntaxError { kind, range: first.range, related: Some(second.range) })
}

/// Returns the keyword at `range`, if it ends a block.
fn block_end(text: &str, range: TextRange) -> Option<&'static str> {
    let keyword = SyntaxKind::from_keyword(text.get(Range::<usize>::from(range))?)?;
    let ends = matches!(keyword, END_IF_KW | END_WHILE_KW | END_FOR_KW | END_SWITCH_KW | UNTIL_KW);
    keyword.keyword_text().filter(|_| ends)
}

/// Replaces all errors from the line with a `]]>` in its code on by one error.
fn without_rest_of_section(text: &str, errors: &[SyntaxError]) -> Vec<SyntaxError> {
    let end = if errors.is_empty() { None } else { early_section_end(text) };
    let Some(end) = end else { return errors.to_vec() };
    let line = text.get(..end).and_then(|before| before.rfind(['\r', '\n'])).unwrap_or(0);
    let before = errors.iter().filter(|error| usize::from(error.range.start()) < line);
    let mut kept: Vec<SyntaxError> = before.cloned().collect();
    if kept.len() < errors.len()
        && let Ok(start) = TextSize::try_from(end)
    {
        let range = TextRange::at(start, TextSize::of(SECTION_END));
        kept.push(SyntaxError { kind: SyntaxErrorKind::EarlySectionEnd, range, related: None });
    }
    kept
}

const SECTION_START: &str = "<![CDATA[";
const SECTION_END: &str = "]]>";

/// Returns the offset of a `]]>` that ends its section too early: another `]]>` follows, but neither an end tag
/// directly after it nor another section in between.
fn early_section_end(text: &str) -> Option<usize> {
    let mut from = 0;
    loop {
        let start = from + text.get(from..)?.find(SECTION_START)? + SECTION_START.len();
        let end = start + text.get(start..)?.find(SECTION_END)?;
        from = end + SECTION_END.len();
        let after = text.get(from..)?;
        let is_proper = ["</", SECTION_START].iter().any(|next| after.trim_start().starts_with(next));
        let next_section = after.find(SECTION_START).unwrap_or(after.len());
        if !is_proper && after.get(..next_section)?.contains(SECTION_END) {
            return Some(end);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    /// Shows each error with its line, its text and the related text.
    fn shown(code: &str) -> Vec<String> {
        let text = format!("<Programs><Program name=\"p\"><Code><![CDATA[{code}]]></Code></Program></Programs>");
        let errors = joined(&text, parse(&text).errors()).into_iter().map(|error| {
            let line = text[..usize::from(error.range.start())].matches('\n').count();
            let related = error.related.map(|range| format!(" {:?}", &text[range])).unwrap_or_default();
            format!("{line} {:?} {:?}{related}", &text[error.range], error.kind)
        });
        errors.collect()
    }

    #[test]
    fn code_without_begin_and_end_is_one_fault() {
        assert_eq!(shown("\na=1\nb=2\n"), [r#"1 "a" MissingBeginAndEnd """#]);
        assert_eq!(shown("begin\na=1\n").len(), 1);
    }

    #[test]
    fn crossed_blocks_are_one_fault() {
        let crossed = r#"CrossedBlocks { inner: "if", early: "endWhile", late: "endIf" } "endIf""#;
        for code in [
            "begin\n  while a\n    if b\n      c=1\n  endWhile\n    endIf\nend",
            "begin\n  while a\n    if b\n      c=1\n    endWhile\n  endIf\nend",
            "begin\nwhile a\nif b\nc=1\nendWhile\nendIf\nend",
        ] {
            assert_eq!(shown(code), [format!("4 \"endWhile\" {crossed}")], "{code}");
        }
        let other = "begin\n  if a\n    while b\n      c=1\n  ENDIF\n    c=2\n    endwhile\nend";
        assert_eq!(
            shown(other),
            [r#"4 "ENDIF" CrossedBlocks { inner: "while", early: "endIf", late: "endWhile" } "endwhile""#]
        );
    }

    #[test]
    fn a_do_block_that_ends_with_while_is_one_fault() {
        let fault = r#""while" DoWhile "do""#;
        assert_eq!(shown("begin\n  do\n    a=1\n  while a<b\nend"), [format!("3 {fault}")]);
        assert_eq!(shown("begin\ndo\na=1\nwhile a<b\nb=2\nend"), [format!("3 {fault}")]);
        assert_eq!(
            shown("begin\n  do\n    a=1\n    do\n      b=1\n    while (b<3)\n  while a<b\nend").len(),
            2,
            "one for each block"
        );
        assert_eq!(shown("begin\n  while a<b\n    do\n      a=1\nend").len(), 2, "the `while` comes first");
    }

    #[test]
    fn separate_faults_are_not_joined() {
        assert_eq!(shown("begin\n  while a\n    if b\n      c=1\n  endWhile\n  c=2\nend").len(), 1);
        assert_eq!(shown("begin\n  endIf\n  while a\n    c=1\nend").len(), 2);
    }

    #[test]
    fn an_early_section_end_is_one_fault() {
        for line in ["s=\"a]]>b\"", "s=\"]]><&\"", "if n[n[0]]>1", "if n[n[0]]>1 and a<b"] {
            let found = shown(&format!("begin\n{line}\nif a<b\nc=1\nendIf\nend"));
            assert_eq!(found, [r#"1 "]]>" EarlySectionEnd"#], "{line}");
        }
        let found = shown("begin\na=)\ns=\"a]]>b\"\nend");
        assert_eq!(found.len(), 2, "{found:?}");
    }

    #[test]
    fn complete_sections_have_no_fault() {
        assert_eq!(early_section_end("<Code><![CDATA[s=\"a]]]]><![CDATA[>b\"]]></Code>"), None);
        assert_eq!(early_section_end("<Code><![CDATA[begin\nend]]>\n</Code><!-- ]]> -->"), None);
        assert_eq!(shown("begin\na=)\nend").len(), 1);
    }
}
