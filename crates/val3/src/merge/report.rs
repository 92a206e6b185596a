//! Report of a merge on the standard error output.

use camino::Utf8Path;
use val3_merge::MergedKind;

use super::contents::Outcome;
use crate::output::to_stderr;
use crate::printable::one_line;

/// How conflicts are found in a file that the check may not read.
const SEARCH: &str = "search the file for `<<<<<<<`, choose a version, and remove the marks";

/// Reports elements with new indexes, and conflicts.
pub(super) fn write(outcome: &Outcome, path: &Utf8Path, kind: MergedKind) {
    lines(outcome, kind).iter().for_each(|line| write_line(path, line));
}

/// Reports a file whose versions are both kept.
pub(crate) fn write_unmerged(path: &Utf8Path, reason: &str) {
    write_line(path, &format!("not merged, both versions are kept: {reason}"));
}

fn write_line(path: &Utf8Path, line: &str) {
    to_stderr(|out| writeln!(out, "{}", one_line(&format!("{path}: {line}"))));
}

fn lines(outcome: &Outcome, kind: MergedKind) -> Vec<String> {
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
        // The check reads only some settings, and no other files.
        1 if kind == MergedKind::Settings => lines.push(format!("1 conflict; {SEARCH}")),
        count if kind == MergedKind::Settings => lines.push(format!("{count} conflicts; {SEARCH}")),
        1 => lines.push("1 conflict; `val3 check` reports it until it is resolved".to_owned()),
        count => lines.push(format!("{count} conflicts; `val3 check` reports each until it is resolved")),
    }
    lines
}
