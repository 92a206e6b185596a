//! Paths that lead to the same file.

use std::fs;

/// Whether two paths lead to the same file, which exists: through a symbolic link, or through the folder above.
#[must_use]
pub fn is_same_file(one: &str, other: &str) -> bool {
    fs::canonicalize(one).is_ok_and(|one| fs::canonicalize(other).is_ok_and(|other| one == other))
}
