//! Files that differ in their XML.

use super::block::{Block, Mark, entry, heading};
use super::settings::setting;
use crate::model::ContentChange;

/// Number of entries of a file that are shown.
const SHOWN: usize = 20;

/// Adds the files with their entries that differ.
pub(super) fn add(files: &[ContentChange], blocks: &mut Vec<Block>) {
    if !files.is_empty() {
        blocks.push(heading(2, "Other attributes and texts of the files", ""));
    }
    for file in files {
        blocks.push(entry(Mark::Changed, &file.path, ""));
        blocks.extend(file.entries.iter().take(SHOWN).map(|change| match setting(change) {
            Block::Entry(mut entry) => {
                entry.mark = Mark::Note;
                Block::Entry(entry)
            }
            block => block,
        }));
        let more = file.entries.len().saturating_sub(SHOWN);
        if more > 0 {
            blocks.push(entry(Mark::Note, "", format!("and {more} more; `--format json` names all")));
        }
    }
}
