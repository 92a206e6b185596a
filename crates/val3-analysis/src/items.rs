//! Declarations of files: names, types, containers, access. Bodies of programs cannot change any of it.
//!
//! Items hold no ranges, so that an edit elsewhere in a file leaves them equal; `declarations` finds the place of
//! an item when a message needs it.

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

/// The tree of a file. To ask for it is to look at the text.
pub fn parse(db: &dyn Db, file: File) -> Parse {
    db.trees().parse(file, file.text(db))
}

/// The file was read, and its XML is well formed.
fn is_sound(db: &dyn Db, file: File) -> bool {
    matches!(file.status(db), FileStatus::Read { .. }) && parse(db, file).errors().is_empty()
}

/// `true` and `false` as files write them.
pub(crate) fn flag(text: &str) -> Option<bool> {
    match text.trim() {
        "true" => Some(true),
        "false" => Some(false),
        _ => None,
    }
}

/// The `size` attribute: one to three dimensions separated by blanks.
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
