//! Result of a pull on the standard error output. The last line is the summary.

use camino::Utf8Path;
use val3_controller::{FileDifference, PullResult, SideChange};

use crate::controller::{counted_files, listed_files, note, shown, shown_bytes};
use crate::user_error::UserError;

/// Reports removed files, remaining conflicts and the numbers.
///
/// # Errors
/// If the current folder is unknown.
pub(super) fn write(result: &PullResult, folder: &Utf8Path) -> Result<(), UserError> {
    if !result.removed.is_empty() {
        let files = listed_files(&result.removed);
        note(&format!("removed here, because the controller no longer has them: {files}"));
    }
    if !result.changed_meanwhile.is_empty() {
        let files = listed_files(&result.changed_meanwhile);
        note(&format!("changed here during the pull, therefore kept, and changed on both sides now: {files}"));
    }
    if !result.unmerged.is_empty() {
        note(
            "help: `val3 pull --print PATH` prints the controller's version; decide with `val3 pull --keep-local PATH`, or \
             with `val3 pull --keep-controller PATH`",
        );
    }
    note(&summary(result, &shown(folder)?));
    Ok(())
}

fn summary(result: &PullResult, folder: &str) -> String {
    let differences = &result.status.differences;
    let bytes = result.status.controller.values().map(|digest| digest.size).sum();
    let mut line = format!(
        "{folder}: {} of the controller ({}), {} updated",
        counted_files(result.status.controller.len()),
        shown_bytes(bytes),
        result.updated.len()
    );
    let is_restored = |path| result.updated.binary_search(path).is_ok();
    let missing = differences.iter().filter(|(path, difference)| {
        matches!(difference, FileDifference::Local(SideChange::Removed)) && !is_restored(path)
    });
    let kept = differences
        .values()
        .filter(|difference| matches!(difference, FileDifference::Local(SideChange::Added | SideChange::Modified)));
    for (count, what) in [
        (result.merged.len(), "merged"),
        (result.removed.len(), "removed here"),
        (result.unmerged.len() + result.changed_meanwhile.len(), "with a conflict left"),
        (kept.count(), "with local changes kept"),
        (missing.count(), "not restored, because they were removed here (--keep-controller restores them)"),
    ] {
        if count > 0 {
            line.push_str(&format!(", {count} {what}"));
        }
    }
    line
}
