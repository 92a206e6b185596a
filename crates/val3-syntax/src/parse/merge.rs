//! Merging of lexer and grammar errors, so that each mistake is reported once.

use std::ops::Range;

use crate::error::{SyntaxError, SyntaxErrorKind};

/// Merges both lists by position. If a line has lexer errors, only the first is kept. If a file has a merge conflict,
/// only the conflicts are reported.
pub(super) fn merge(text: &str, lexer: Vec<SyntaxError>, grammar: Vec<SyntaxError>) -> Vec<SyntaxError> {
    if lexer.is_empty() && grammar.is_empty() {
        return Vec::new();
    }
    if lexer.iter().any(is_conflict) {
        return conflicts(text, lexer);
    }
    let mut faults: Vec<MergedError> = Vec::with_capacity(lexer.len() + grammar.len());
    faults.extend(lexer.into_iter().map(|error| MergedError { error, of_lexer: true }));
    faults.extend(grammar.into_iter().map(|error| MergedError { error, of_lexer: false }));
    faults.sort_by_key(|fault| (fault.error.range.start(), fault.error.range.end()));
    drop_cascades(text, faults)
}

struct MergedError {
    error: SyntaxError,
    of_lexer: bool,
}

fn is_conflict(error: &SyntaxError) -> bool {
    error.kind == SyntaxErrorKind::ConflictMarker
}

/// Keeps one error for each conflict: its opening marker, or the first marker if none opens.
fn conflicts(text: &str, lexer: Vec<SyntaxError>) -> Vec<SyntaxError> {
    let mut markers: Vec<_> = lexer.into_iter().filter(is_conflict).collect();
    if markers.iter().any(|marker| opens(text, marker)) {
        markers.retain(|marker| opens(text, marker));
    } else {
        markers.truncate(1);
    }
    markers
}

/// Whether the marker opens a conflict: `<<<<<<<` or `&lt;&lt;…`.
fn opens(text: &str, marker: &SyntaxError) -> bool {
    let marker = text.get(Range::<usize>::from(marker.range));
    marker.is_some_and(|text| text.starts_with(['<', '&']) && !text.starts_with("&gt;"))
}

/// Removes errors that are consequences of the first lexer error on a line.
fn drop_cascades(text: &str, faults: Vec<MergedError>) -> Vec<SyntaxError> {
    let mut kept = Vec::with_capacity(faults.len());
    for line in faults.chunk_by(|a, b| on_one_line(text, &a.error, &b.error)) {
        let first = line.iter().position(|fault| fault.of_lexer);
        for (at, fault) in line.iter().enumerate() {
            let is_cause = first.is_none_or(|first| at == first);
            if is_cause || !fault.of_lexer && is_about_other_lines(&fault.error.kind) {
                kept.push(fault.error.clone());
            }
        }
    }
    kept
}

/// Whether the error is reported on this line but caused by other lines of a block.
fn is_about_other_lines(kind: &SyntaxErrorKind) -> bool {
    use SyntaxErrorKind::{MissingBreak, MissingEnd, UnclosedBlock, UnmatchedBlockEnd};
    matches!(kind, UnclosedBlock { .. } | UnmatchedBlockEnd { .. } | MissingBreak | MissingEnd)
}

fn on_one_line(text: &str, a: &SyntaxError, b: &SyntaxError) -> bool {
    let between = text.get(usize::from(a.range.start())..usize::from(b.range.start()));
    !between.unwrap_or("").contains(['\n', '\r'])
}
