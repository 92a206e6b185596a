//! Report of a merge on the standard error output.

use camino::Utf8Path;

use super::contents::Outcome;
use crate::output::to_stderr;
use crate::printable::one_line;

/// Reports elements with new indexes, and conflicts.
pub(super) fn write(outcome: &Outcome, path: &Utf8Path) {
    for line in lines(outcome) {
        to_stderr(|out| writeln!(out, "{}", one_line(&format!("{path}: {line}"))));
    }
}

fn lines(outcome: &Outcome) -> Vec<String> {
    let merged = match &outcome.merged {
        Ok(merged) => merged,
        Err(reason) => return vec![format!("not merged, OURS is unchanged: {reason}")],
    };
    let mut lines = Vec::new();
    for moved in &merged.moved {
        lines.push(format!("{moved}; check the programs of theirs that use it"));
    }
    if let Some(reason) = &merged.by_lines {
        lines.push(format!("merged by lines, so compare the result with both versions: {reason}"));
    }
    lines.extend(merged.conflicts.iter().map(ToString::to_string));
    match merged.conflicts.len() {
        0 => {}
        1 => lines.push("1 conflict; `val3 check` reports it until it is resolved".to_owned()),
        count => lines.push(format!("{count} conflicts; `val3 check` reports each until it is resolved")),
    }
    lines
}
