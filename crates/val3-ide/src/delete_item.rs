//! Deletion of programs, data, libraries and types.

use smol_str::SmolStr;
use val3_analysis::db::{Db, File, FileRange, Project};
use val3_analysis::items::manifest::manifest;
use val3_analysis::items::parse;
use val3_analysis::occurrences::Symbol;
use val3_analysis::xml;
use val3_syntax::TextRange;

use crate::FilePosition;
use crate::RefactoringError;
use crate::data_edits::{DataEdit, data_edits};
use crate::declare::without;
use crate::edit::SourceChange;
use crate::file_operations::will_delete_files;
use crate::owner::owner;
use crate::project_tree::{TreeItem, project_content};
use crate::references::places;

/// Result of deleting an item.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Deletion {
    /// Change that removes the declaration. A program is deleted with its file and its elements in project files.
    pub change: SourceChange,
    /// Remaining uses outside the declaration, sorted by path and offset.
    pub uses: Vec<FileRange>,
}

/// Deletes the program, data, library or type whose declared name is at the position.
///
/// # Errors
/// If no such declaration is there, or if its file has errors, because the deletion might then remove more than the
/// declaration.
pub fn delete_item(db: &dyn Db, at: FilePosition) -> Result<Deletion, RefactoringError> {
    let nothing = || RefactoringError("there is no program, data, library or type declared here".to_owned());
    let project = owner(db, at.file).ok_or_else(nothing)?;
    let item = find(db, project, at).ok_or_else(nothing)?;
    let change = match &item.symbol {
        Symbol::Program(..) => program(db, project, at.file)?,
        Symbol::Data(_, name) => datum(db, project, at.file, name)?,
        _ => entry(db, at.file, item.range)?,
    };
    let mut uses = places(db, &item.symbol, false);
    uses.retain(|place| !change.deletes.contains(place.file.path(db)));
    Ok(Deletion { change, uses })
}

struct Item {
    symbol: Symbol,
    /// Range of the entire declaration.
    range: TextRange,
}

fn find(db: &dyn Db, project: Project, at: FilePosition) -> Option<Item> {
    let content = project_content(db, project);
    find_in(&content.programs, at, |name| Symbol::Program(project, name))
        .or_else(|| find_in(&content.data, at, |name| Symbol::Data(project, name)))
        .or_else(|| find_in(&content.libraries, at, |name| Symbol::Library(project, name)))
        .or_else(|| find_in(&content.types, at, |name| Symbol::Type(project, name)))
}

fn find_in<T>(items: &[TreeItem<T>], at: FilePosition, symbol: impl Fn(SmolStr) -> Symbol) -> Option<Item> {
    let mut items = items.iter().filter(|item| item.file == at.file);
    let item = items.find(|item| item.name_range.contains_inclusive(at.offset))?;
    Some(Item { symbol: symbol(item.name.clone()), range: item.range })
}

fn program(db: &dyn Db, project: Project, file: File) -> Result<SourceChange, RefactoringError> {
    sound(db, project.manifest(db))?;
    let parse = parse(db, file);
    let programs = xml::root(parse.view()).map_or(0, |root| root.elements().count());
    if programs > 1 {
        let reason = format!("`{}` has more programs than this one. Delete it in the text", name(db, file));
        return Err(RefactoringError(reason));
    }
    let path = file.path(db).clone();
    let change = will_delete_files(db, std::slice::from_ref(&path));
    Ok(SourceChange { deletes: vec![path], ..change })
}

fn datum(db: &dyn Db, project: Project, file: File, name: &SmolStr) -> Result<SourceChange, RefactoringError> {
    let delete = DataEdit::Delete(vec![name.to_string()]);
    data_edits(db, project, file, &[delete]).map_err(|problem| RefactoringError(problem.reason))
}

fn entry(db: &dyn Db, manifest: File, range: TextRange) -> Result<SourceChange, RefactoringError> {
    sound(db, manifest)?;
    Ok(SourceChange::of([without(db, manifest, range)]))
}

fn sound(db: &dyn Db, file: File) -> Result<(), RefactoringError> {
    if manifest(db, file).complete {
        return Ok(());
    }
    let reason = format!("`{}` has errors. Correct them first, so that nothing else is deleted", name(db, file));
    Err(RefactoringError(reason))
}

fn name(db: &dyn Db, file: File) -> &str {
    file.path(db).file_name().unwrap_or("")
}

#[cfg(test)]
mod tests;
