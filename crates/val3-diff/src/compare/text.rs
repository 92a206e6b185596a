//! Comparison of text lines.

use similar::{ChangeTag, DiffOp, TextDiff};

use crate::model::{Change, Hunk, HunkLine, LineKind, Problem, TextChange, TreeSide};
use crate::read::code::line_ends;
use crate::tree::text_of;

/// Number of equal lines shown before and after lines that differ.
const CONTEXT: usize = 3;

/// A line of a version.
#[derive(Debug)]
pub(crate) struct VersionLine {
    /// Line number, from 1.
    pub(crate) number: usize,
    pub(crate) text: String,
    /// Text by which lines of both versions are matched.
    pub(crate) key: String,
}

/// Returns the lines that differ with context. Line ends are ignored.
pub(crate) fn hunks(old: &str, new: &str) -> Vec<Hunk> {
    hunks_of(&version_lines(old), &version_lines(new))
}

fn version_lines(text: &str) -> Vec<VersionLine> {
    let text = line_ends(text);
    let lines = (1..).zip(text.lines());
    lines.map(|(number, text)| VersionLine { number, text: text.to_owned(), key: text.to_owned() }).collect()
}

/// Returns the lines whose keys differ with context.
pub(crate) fn hunks_of(old: &[VersionLine], new: &[VersionLine]) -> Vec<Hunk> {
    let keys = |lines: &'_ [VersionLine]| -> Vec<String> { lines.iter().map(|line| line.key.clone()).collect() };
    let (old_keys, new_keys) = (keys(old), keys(new));
    let (old_keys, new_keys): (Vec<&str>, Vec<&str>) =
        (old_keys.iter().map(String::as_str).collect(), new_keys.iter().map(String::as_str).collect());
    let diff = TextDiff::from_slices(&old_keys, &new_keys);
    diff.grouped_ops(CONTEXT).iter().map(|group| hunk(&diff, group, old, new)).collect()
}

fn hunk<'k>(diff: &TextDiff<'k, 'k, str>, group: &[DiffOp], old: &[VersionLine], new: &[VersionLine]) -> Hunk {
    let mut hunk = Hunk { old_start: 0, old_lines: 0, new_start: 0, new_lines: 0, lines: Vec::new() };
    if let Some(first) = group.first() {
        (hunk.old_start, hunk.new_start) = (number(old, first.old_range().start), number(new, first.new_range().start));
    }
    for change in group.iter().flat_map(|op| diff.iter_changes(op)) {
        let (kind, line) = match change.tag() {
            ChangeTag::Equal => (LineKind::Context, change.new_index().and_then(|index| new.get(index))),
            ChangeTag::Delete => (LineKind::Removed, change.old_index().and_then(|index| old.get(index))),
            ChangeTag::Insert => (LineKind::Added, change.new_index().and_then(|index| new.get(index))),
        };
        hunk.old_lines += usize::from(kind != LineKind::Added);
        hunk.new_lines += usize::from(kind != LineKind::Removed);
        hunk.lines.extend(line.map(|line| HunkLine { kind, number: line.number, text: line.text.clone() }));
    }
    // As in other tools, a hunk without lines starts after the preceding line.
    hunk.old_start -= usize::from(hunk.old_lines == 0 && hunk.old_start > 0);
    hunk.new_start -= usize::from(hunk.new_lines == 0 && hunk.new_start > 0);
    hunk
}

/// Returns the number of a line; after the last line, the next number.
fn number(lines: &[VersionLine], index: usize) -> usize {
    lines.get(index).map_or_else(|| lines.last().map_or(1, |last| last.number + 1), |line| line.number)
}

/// Counts the lines with this kind.
pub(crate) fn count(hunks: &[Hunk], kind: LineKind) -> usize {
    hunks.iter().flat_map(|hunk| &hunk.lines).filter(|line| line.kind == kind).count()
}

/// Expected content of a configuration file.
pub(super) const XML: &str = "XML";

/// A version of a file: its bytes, and whether it is readable as VAL 3.
#[derive(Clone, Copy)]
pub(super) struct Version<'t> {
    pub(super) bytes: &'t [u8],
    pub(super) is_readable: bool,
}

/// Compares a file as text, because a version is not readable as `expected`.
pub(super) fn compare(
    path: &str,
    [old, new]: [Option<Version<'_>>; 2],
    expected: &str,
    problems: &mut Vec<Problem>,
) -> Option<TextChange> {
    let bytes = |version: Option<Version<'_>>| version.map(|version| version.bytes.to_vec());
    if bytes(old) == bytes(new) {
        return None;
    }
    let mut texts = [String::new(), String::new()];
    for ((version, side), text) in [(old, TreeSide::Old), (new, TreeSide::New)].into_iter().zip(&mut texts) {
        let Some(version) = version else { continue };
        let message = match text_of(version.bytes) {
            Err(reason) => format!("the file cannot be read: {reason}"),
            Ok(found) => {
                *text = found.to_string();
                let help = if expected == XML { "restore it from a backup" } else { "`val3 check` shows the faults" };
                format!("this is not {expected}, so the file was compared as text; {help}")
            }
        };
        if !version.is_readable {
            problems.push(Problem { path: path.to_owned(), side, message });
        }
    }
    let [old_text, new_text] = texts;
    let change = Change::of(old.is_some(), new.is_some());
    let hunks = if change == Change::Changed { hunks(&old_text, &new_text) } else { Vec::new() };
    Some(TextChange { path: path.to_owned(), change, hunks })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hunks_count_lines_from_1() {
        let found = hunks("begin\na\nb\nc\nd\ne\nend", "begin\r\na\r\nb\r\nc\r\nd\r\nf\r\nend");
        let shown: Vec<String> = found
            .iter()
            .flat_map(|hunk| &hunk.lines)
            .map(|line| format!("{:?} {} {}", line.kind, line.number, line.text))
            .collect();
        assert_eq!(shown, ["Context 3 b", "Context 4 c", "Context 5 d", "Removed 6 e", "Added 6 f", "Context 7 end"]);
        assert_eq!((found[0].old_start, found[0].old_lines, found[0].new_start, found[0].new_lines), (3, 5, 3, 5));
        assert!(hunks("a\r\n", "a\n").is_empty());
    }
}
