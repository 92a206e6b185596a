//! Laws of the rename for task names, which are strings.

use val3_analysis::db::FileRange;
use val3_analysis::occurrences::{Symbol, Usage, occurrences};
use val3_ide::{FilePosition, RefactoringError, projects_of, rename};
use val3_syntax::TextSize;

use crate::assists::edited_cell::{Counts, EditedCell, counted, surplus};

/// A name that no task has.
const NEW: &str = "zqTask";

/// Returns the names in `taskCreate` that are string literals, at most `most`.
pub(crate) fn tasks(cell: &EditedCell, most: usize) -> Vec<(FileRange, String)> {
    let db = cell.db();
    let mut tasks = Vec::new();
    for file in cell.project_files() {
        for found in projects_of(db, file).iter().flat_map(|project| occurrences(db, *project, file)) {
            if let (Symbol::Task(_, name), Usage::Declaration) = (&found.symbol, found.usage) {
                tasks.push((FileRange { file, range: found.range }, name.to_string()));
            }
        }
    }
    let step = tasks.len().div_ceil(most).max(1);
    tasks.into_iter().step_by(step).collect()
}

/// Renames a task to a new name and back. The error is the reason why this is rejected; otherwise returns the failures.
pub(crate) fn there_and_back(
    cell: &mut EditedCell,
    findings: &Counts,
    task: &(FileRange, String),
) -> Result<Vec<String>, RefactoringError> {
    let (place, old) = task;
    let at = FilePosition { file: place.file, offset: place.range.start() };
    let change = rename(cell.db(), at, NEW)?;
    let before = change.edits.iter().filter(|edit| edit.file == at.file && edit.range.end() <= at.offset);
    let offset = before.fold(at.offset, |offset, edit| offset + TextSize::of(&edit.text) - edit.range.len());
    let there = match cell.apply(&change) {
        Ok(there) => there,
        Err(failure) => return Ok(vec![failure]),
    };
    let named = |(finding, count): (String, usize)| vec![finding.replace(NEW, old); count];
    let after = counted(cell.findings().into_iter().flat_map(named));
    let mut failures = surplus(&after, findings);
    failures.extend(surplus(findings, &after));
    let back = rename(cell.db(), FilePosition { file: at.file, offset }, old).map_err(|error| error.0);
    match back.and_then(|back| cell.apply(&back)) {
        Ok(_) if there.iter().all(|(path, bytes)| cell.bytes(path) == bytes.as_ref()) => {}
        Ok(_) => failures.push("the way back does not restore every byte".to_owned()),
        Err(failure) => failures.push(failure),
    }
    cell.restore(&there);
    Ok(failures)
}
