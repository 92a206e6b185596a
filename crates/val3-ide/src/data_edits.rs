//! Edits of a data file's tables as text edits in the format of the file, restricted to the changed parts.

mod cells;
mod check;
mod containers;
mod declarations;
mod edit;
mod initial;
mod target;
mod walk;

pub use check::added_data_findings;
pub use edit::{CellEdit, DataEdit, NewDatum};

use std::ops::Range;

use val3_analysis::db::{Db, File, FileStatus, Project};
use val3_analysis::items::parse;
use val3_data::compose;
use val3_syntax::TextEdit;
use val3_syntax::encoding::Encoding;

use crate::data_tables::{DataProblem, problem};
use crate::edit::{FileEdit, SourceChange};
use target::DataFile;

/// Text edits that apply these table edits. Each edit applies to the result of the previous ones.
///
/// # Errors
/// If an edit is impossible, or if the file has syntax errors.
pub fn data_edits(db: &dyn Db, project: Project, file: File, edits: &[DataEdit]) -> Result<SourceChange, DataProblem> {
    if let Some(problem) = problem(db, file) {
        return Err(problem);
    }
    let mut text = String::new();
    let mut done: Vec<TextEdit> = Vec::new();
    for (at, edit) in edits.iter().enumerate() {
        let is_first = at == 0;
        let current = if is_first { file.text(db) } else { text.as_str() };
        let parse = if is_first { parse(db, file) } else { val3_syntax::parse(current) };
        let target = DataFile::new(db, project, file, current, parse.view())?;
        let new = change(&target, edit).map_err(|problem| without_range(problem, is_first))?;
        if at + 1 < edits.len() {
            text = TextEdit::apply_all(current, &new);
        }
        done = compose(&done, &new);
    }
    let encoding = match file.status(db) {
        FileStatus::Read { encoding, .. } => *encoding,
        FileStatus::Unreadable(_) => Encoding::Utf8,
    };
    done.retain(|edit| changes(file.text(db), edit));
    let edits =
        done.into_iter().map(|edit| FileEdit { file, range: edit.range, text: with_references(&edit.text, encoding) });
    Ok(SourceChange::of(edits))
}

/// Whether the edit changes the text.
fn changes(text: &str, edit: &TextEdit) -> bool {
    text.get(Range::<usize>::from(edit.range)) != Some(edit.text.as_str())
}

fn change(target: &DataFile<'_>, edit: &DataEdit) -> Result<Vec<TextEdit>, DataProblem> {
    match edit {
        DataEdit::Set(cells) => cells::set(target, cells),
        DataEdit::Add(new) => declarations::add(target, new),
        DataEdit::Duplicate { name, new_name } => declarations::duplicate(target, name, new_name),
        DataEdit::Delete(names) => declarations::delete(target, names),
        DataEdit::Access { names, public } => declarations::access(target, names, *public),
        DataEdit::Resize { place, sizes } => containers::resize(target, place, sizes),
        DataEdit::AddKey { place, key } => containers::add_key(target, place, key),
        DataEdit::RemoveKeys { place, keys } => containers::remove_keys(target, place, keys),
        DataEdit::RenameKey { place, key, new_key } => containers::rename_key(target, place, key, new_key),
    }
}

/// Removes the range if it refers to an intermediate text, which the reader does not have.
fn without_range(problem: DataProblem, has_place: bool) -> DataProblem {
    DataProblem { range: problem.range.filter(|_| has_place), ..problem }
}

/// Replaces characters outside the encoding by XML character references.
fn with_references(text: &str, encoding: Encoding) -> String {
    let mut out = String::with_capacity(text.len());
    for character in text.chars() {
        if encoding.supports(character) {
            out.push(character);
        } else {
            out.push_str(&format!("&#{};", u32::from(character)));
        }
    }
    out
}

#[cfg(test)]
mod tests;
