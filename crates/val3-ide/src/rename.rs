//! Renaming of a name at all its uses.

mod conflicts;
mod elements;
mod keys;
mod tasks;

pub(crate) use conflicts::{check_no_unresolved_use, check_variable_name, name_fault, other_item};
pub(crate) use keys::{Index, index, spelt_keys};

use camino::Utf8Path;
use smol_str::SmolStr;
use val3_analysis::application::ENTRY_POINTS;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::project::items;
use val3_analysis::occurrences::Symbol;
use val3_syntax::TextRange;

use crate::FilePosition;
use crate::RefactoringError;
use crate::edit::{FileEdit, SourceChange};
use crate::navigate::{implemented, implementing, name_at};
use crate::references::{text, uses};

/// Range and text of the name, or key of a collection, at a position, if it can be renamed.
///
/// # Errors
/// If there is no name, or if it belongs to the language or the controller.
pub fn prepare_rename(db: &dyn Db, at: FilePosition) -> Result<(TextRange, String), RefactoringError> {
    if let Some(found) = keys::key_at(db, at) {
        return Ok((found.range, found.key));
    }
    let Some((_, found)) = name_at(db, at) else {
        return Err(RefactoringError("there is no name here that can be changed".to_owned()));
    };
    conflicts::check_renamable(db, &found.symbol)?;
    Ok((found.range, text(&found.symbol).to_owned()))
}

/// Renames the name at a position to `new_name` in all files.
///
/// # Errors
/// If the name cannot be changed, or if `new_name` is invalid, in use, or would change the meaning of a use.
pub fn rename(db: &dyn Db, at: FilePosition, new_name: &str) -> Result<SourceChange, RefactoringError> {
    prepare_rename(db, at)?;
    if let Some(found) = keys::key_at(db, at) {
        return keys::rename(db, &found, new_name);
    }
    let Some((_, found)) = name_at(db, at) else { return Ok(SourceChange::default()) };
    let symbols = together(db, &found.symbol);
    match &found.symbol {
        Symbol::Task(project, _) => tasks::check(db, *project, new_name)?,
        Symbol::Element(page, _) => elements::check(db, *page, new_name)?,
        _ => conflicts::check(db, &symbols, new_name)?,
    }
    let mut change = SourceChange::default();
    for symbol in &symbols {
        let edit = |(file, _, range): (File, Project, TextRange)| FileEdit { file, range, text: new_name.to_owned() };
        change.edits.extend(uses(db, symbol).map(edit));
        change.moves.extend(moved_file(db, symbol, new_name));
    }
    change.edits.sort_by_key(|edit| (edit.file.path(db), edit.range.start()));
    change.edits.dedup();
    Ok(change)
}

/// Symbols that share a name: an interface item, and the same item in all libraries that are loaded for the interface,
/// transitively.
pub(crate) fn together(db: &dyn Db, symbol: &Symbol) -> Vec<Symbol> {
    let mut symbols = vec![symbol.clone()];
    let mut next = 0;
    while let Some(symbol) = symbols.get(next).cloned() {
        for other in same_item(db, &symbol) {
            if !symbols.contains(&other) {
                symbols.push(other);
            }
        }
        next += 1;
    }
    symbols
}

/// The same item in projects that are loaded for this project's interface, or whose interface this project implements.
fn same_item(db: &dyn Db, symbol: &Symbol) -> Vec<Symbol> {
    let related = |project: Project| implementing(db, project).chain(implemented(db, project));
    match symbol {
        Symbol::Data(project, name) => {
            let declares = |project: &Project| items(db, *project).data.contains_key(name);
            related(*project).filter(declares).map(|project| Symbol::Data(project, name.clone())).collect()
        }
        Symbol::Program(project, name) if !ENTRY_POINTS.contains(&name.as_str()) => {
            let declares = |project: &Project| items(db, *project).programs.contains_key(name);
            related(*project).filter(declares).map(|project| Symbol::Program(project, name.clone())).collect()
        }
        _ => Vec::new(),
    }
}

/// Old and new path of the program's file, if the file has the program's name in any letter case.
fn moved_file(db: &dyn Db, symbol: &Symbol, new_name: &str) -> Option<(camino::Utf8PathBuf, camino::Utf8PathBuf)> {
    let Symbol::Program(project, name) = symbol else { return None };
    let path: &Utf8Path = items(db, *project).programs.get(name)?.path(db);
    let same = path.file_stem().is_some_and(|stem| stem.eq_ignore_ascii_case(name));
    let extension = path.extension().unwrap_or("pgx");
    same.then(|| (path.to_owned(), path.with_file_name(SmolStr::new(new_name)).with_extension(extension)))
}

#[cfg(test)]
mod tests;
