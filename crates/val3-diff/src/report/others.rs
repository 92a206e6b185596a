//! Report of other kinds of files.

use super::block::{Block, ReportMark, entry, heading};
use crate::model::{Change, OtherChange};

/// Number of files that are named in a report. The JSON document names all.
const SHOWN: usize = 20;

/// Adds the files that differ.
pub(super) fn add(files: &[OtherChange], blocks: &mut Vec<Block>) {
    if files.is_empty() {
        return;
    }
    blocks.push(heading(1, "Other files", "compared by their bytes"));
    for file in files.iter().take(SHOWN) {
        let word = match file.change {
            Change::Added => "new file",
            Change::Removed => "the file was removed",
            Change::Changed => "",
        };
        blocks.push(entry(file.change.into(), &file.path, word));
    }
    let more = files.len().saturating_sub(SHOWN);
    if more > 0 {
        blocks.push(entry(ReportMark::Note, "", format!("and {more} more; `--format json` names all")));
    }
}
