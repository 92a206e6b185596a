//! Law of fixes: they add no error.

use std::collections::BTreeMap;

use val3_check::rule::Severity;
use val3_check::testing::{OfferedFix, check_files, fixed_files};

use crate::cell::Cell;

/// Applies all fixes, safe or not, and returns the added errors.
pub fn errors_of_fixes(files: &Cell) -> Vec<String> {
    added_errors(files, &fixed_files(files))
}

/// Applies one fix, and returns the added errors.
///
/// # Panics
/// The fix edits a file that does not exist or is not in UTF-8.
pub fn errors_of_fix(files: &Cell, fix: &OfferedFix) -> Vec<String> {
    added_errors(files, &with_fix(files, fix))
}

fn with_fix(files: &Cell, fix: &OfferedFix) -> Cell {
    let mut fixed = files.clone();
    let mut edits = fix.edits.clone();
    // From the end of a file to its start, so that the ranges of other edits stay valid.
    edits.sort_by_key(|(_, range, _)| std::cmp::Reverse(range.start));
    for (file, range, text) in edits {
        let (_, bytes) = fixed.iter_mut().find(|(path, _)| *path == file).expect("a fix edits a known file");
        let mut new = String::from_utf8(std::mem::take(bytes)).expect("the files are in UTF-8");
        new.replace_range(range, &text);
        *bytes = new.into_bytes();
    }
    fixed
}

fn added_errors(before: &Cell, after: &Cell) -> Vec<String> {
    if before == after {
        return Vec::new();
    }
    let (before, after) = (errors(before), errors(after));
    after.into_iter().filter(|(error, count)| before.get(error).is_none_or(|it| it < count)).map(|(it, _)| it).collect()
}

/// Counts equal errors. Line numbers are omitted, because fixes move lines.
fn errors(files: &Cell) -> BTreeMap<String, usize> {
    let mut errors = BTreeMap::new();
    for found in check_files(files).into_iter().filter(|found| found.severity == Severity::Error) {
        *errors.entry(format!("{} {}: {}", found.code, found.file, found.message)).or_default() += 1;
    }
    errors
}
