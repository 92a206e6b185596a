//! Results of merges as displayed.

mod code;
mod data;
mod lists;

use std::fmt::Write as _;

use val3_syntax::error::SyntaxErrorKind;

use crate::{MergedKind, merge};

/// Shows the result of a merge: the text, and the report.
fn merged(kind: MergedKind, base: &str, ours: &str, theirs: &str) -> String {
    let merged = merge(kind, base, ours, theirs);
    let mut out = merged.text.trim_start_matches('\u{feff}').replace("\r\n", "\n");
    merged.moved.iter().for_each(|moved| writeln!(out, "\n# {moved}").unwrap());
    merged.conflicts.iter().for_each(|conflict| writeln!(out, "\n! {conflict}").unwrap());
    merged.by_lines.iter().for_each(|reason| writeln!(out, "\n! by lines: {reason}").unwrap());
    let parse = val3_syntax::parse(&merged.text);
    let is_marked = parse.errors().iter().any(|error| error.kind == SyntaxErrorKind::ConflictMarker);
    assert_eq!(is_marked, !merged.conflicts.is_empty(), "{out}");
    out
}
