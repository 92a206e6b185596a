//! Declarations in files: names, types, containers, access. The code of programs cannot change them.
//!
//! Items contain no ranges, so they do not change if another part of the file is edited. `declarations` finds an item's
//! range when a message needs it.

pub mod attributes;
pub mod data;
pub mod declarations;
pub mod fathers;
pub mod faults;
pub(crate) mod file_entry;
pub mod initial;
pub mod input_links;
pub mod layout;
pub mod limits;
pub mod manifest;
pub mod positions;
pub mod program;
pub mod project;
pub mod shared_names;
pub mod suppressions;
pub mod unlisted;

use val3_syntax::Parse;

use crate::db::{Db, File, FileStatus};

/// Returns the tree of a file. A query that calls this depends on the file's text.
pub fn parse(db: &dyn Db, file: File) -> Parse {
    db.trees().parse(file, file.text(db))
}

/// Whether the file was read and its XML is well-formed.
fn is_sound(db: &dyn Db, file: File) -> bool {
    matches!(file.status(db), FileStatus::Read { .. }) && parse(db, file).errors().is_empty()
}

/// Parses `true` and `false` as spelt in files.
pub(crate) fn flag(text: &str) -> Option<bool> {
    match text.trim() {
        "true" => Some(true),
        "false" => Some(false),
        _ => None,
    }
}

/// Parses the `size` attribute: one to three dimensions separated by blanks.
pub fn sizes(text: &str) -> Option<Vec<u32>> {
    let sizes: Option<Vec<u32>> = text.split_ascii_whitespace().map(|size| size.parse().ok()).collect();
    sizes.filter(|sizes| (1..=3).contains(&sizes.len()))
}

#[cfg(test)]
mod tests {
    use super::sizes;

    #[test]
    fn a_size_has_one_to_three_numbers() {
        assert_eq!(sizes("3"), Some(vec![3]));
        assert_eq!(sizes(" 30 1  1 "), Some(vec![30, 1, 1]));
        for text in ["", " ", "1 2 3 4", "1,2", "-1", "1.0", "4294967296"] {
            assert_eq!(sizes(text), None, "{text}");
        }
    }
}
