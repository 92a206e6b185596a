//! Comparison of paths by their files.

use std::fs;

/// Whether both paths resolve to the same existing file, for example through a symbolic link or a parent folder.
#[must_use]
pub fn is_same_file(one: &str, other: &str) -> bool {
    fs::canonicalize(one).is_ok_and(|one| fs::canonicalize(other).is_ok_and(|other| one == other))
}
