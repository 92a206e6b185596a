//! Report of files that differ in their XML.

use super::block::{Block, ReportMark, entry, heading};
use super::changes::optional_arrow;
use crate::model::{ContentChange, EntryChange};

/// Number of entries that are shown for a file.
const SHOWN: usize = 20;

/// Adds the files with the entries that differ.
pub(super) fn add(files: &[ContentChange], blocks: &mut Vec<Block>) {
    if !files.is_empty() {
        blocks.push(heading(2, "Other attributes and texts of the files", ""));
    }
    for file in files {
        blocks.push(entry(ReportMark::Changed, &file.path, ""));
        blocks
            .extend(file.entries.iter().take(SHOWN).map(|change| entry(ReportMark::Note, &change.entry, text(change))));
        let more = file.entries.len().saturating_sub(SHOWN);
        if more > 0 {
            blocks.push(entry(ReportMark::Note, "", format!("and {more} more; `--format json` names all")));
        }
    }
}

/// Formats a changed attribute as `num → numx`, an element as `added` or `removed`.
fn text(change: &EntryChange) -> String {
    match (change.old.as_deref(), change.new.as_deref()) {
        (None, Some("")) => "added".to_owned(),
        (Some(""), None) => "removed".to_owned(),
        _ => optional_arrow(change.old.as_ref(), change.new.as_ref()),
    }
}
