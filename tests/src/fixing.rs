//! The law of fixes: they add no error.

use std::collections::BTreeMap;

use val3_check::rule::Severity;
use val3_check::testing::{check_files, fixed_files};

use crate::cell::Cell;

/// The errors that are there once all fixes are applied, safe or not, and were not there before.
pub fn errors_of_fixes(files: &Cell) -> Vec<String> {
    let before = errors(files);
    let after = errors(&fixed_files(files));
    after.into_iter().filter(|(error, count)| before.get(error).is_none_or(|it| it < count)).map(|(it, _)| it).collect()
}

/// Each error with how often it is there. Lines are left out: fixes move them.
fn errors(files: &Cell) -> BTreeMap<String, usize> {
    let mut errors = BTreeMap::new();
    for found in check_files(files).into_iter().filter(|found| found.severity == Severity::Error) {
        *errors.entry(format!("{} {}: {}", found.code, found.file, found.message)).or_default() += 1;
    }
    errors
}
