//! What stands against a new name.

use smol_str::SmolStr;
use val3_analysis::application::ENTRY_POINTS;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::program::header;
use val3_analysis::items::project::items;
use val3_analysis::occurrences::Symbol;
use val3_lang::keywords;

use super::RenameError;
use crate::references::{text, uses};

fn refused(reason: String) -> Result<(), RenameError> {
    Err(RenameError(reason))
}

/// The name is one that the files declare, and nobody else relies on it.
pub(super) fn is_ours(symbol: &Symbol) -> Result<(), RenameError> {
    let name = text(symbol);
    match symbol {
        Symbol::Program(_, name) if ENTRY_POINTS.contains(&name.as_str()) => {
            refused(format!("the controller itself calls `{name}`"))
        }
        Symbol::Local(..)
        | Symbol::Param(..)
        | Symbol::Data(..)
        | Symbol::Program(..)
        | Symbol::Library(..)
        | Symbol::Type(..) => Ok(()),
        Symbol::Instruction(_)
        | Symbol::Builtin(_)
        | Symbol::Enumerator(_)
        | Symbol::Field(..)
        | Symbol::BuiltinType(_) => refused(format!("`{name}` belongs to the language")),
    }
}

/// The new name is one, is free, and means the same thing at every place.
pub(super) fn check(db: &dyn Db, project: Project, symbols: &[Symbol], new_name: &str) -> Result<(), RenameError> {
    if !keywords::is_identifier(new_name) {
        return refused(format!("`{new_name}` is no name: letters, digits and `_`, no digit first"));
    }
    if let Some(word) = keywords::canonical(new_name) {
        return refused(format!("`{word}` is a word of the language"));
    }
    if let Some(limit) = items(db, project).version.identifier_limit().filter(|limit| new_name.len() > *limit) {
        return refused(format!("names have at most {limit} characters in this version"));
    }
    symbols.iter().try_for_each(|symbol| free(db, symbol, new_name))
}

fn free(db: &dyn Db, symbol: &Symbol, new_name: &str) -> Result<(), RenameError> {
    match symbol {
        Symbol::Local(file, _) | Symbol::Param(file, _) => {
            not_declared_in(db, *file, new_name)?;
            hides_no_data(db, *file, new_name)
        }
        Symbol::Data(project, _) => {
            if items(db, *project).data.contains_key(new_name) {
                return refused(format!("there is data called `{new_name}` already"));
            }
            users(db, symbol).try_for_each(|file| not_declared_in(db, file, new_name))
        }
        Symbol::Program(project, _) => {
            let taken = items(db, *project).programs.keys().any(|name| name.eq_ignore_ascii_case(new_name));
            if taken { refused(format!("there is a program called `{new_name}` already")) } else { Ok(()) }
        }
        Symbol::Library(project, _) => {
            let taken = items(db, *project).libraries.contains_key(new_name);
            if taken { refused(format!("there is a library identifier `{new_name}` already")) } else { Ok(()) }
        }
        Symbol::Type(project, _) => {
            let taken = items(db, *project).types.contains_key(new_name);
            if taken { refused(format!("there is a user type called `{new_name}` already")) } else { Ok(()) }
        }
        _ => Ok(()),
    }
}

/// The files that name a symbol.
fn users(db: &dyn Db, symbol: &Symbol) -> impl Iterator<Item = File> {
    let mut files: Vec<File> = uses(db, symbol).map(|(file, ..)| file).collect();
    files.dedup();
    files.into_iter()
}

/// No local or parameter of the program has the name: it would hide what is renamed, or clash with it.
fn not_declared_in(db: &dyn Db, file: File, new_name: &str) -> Result<(), RenameError> {
    let header = header(db, file);
    let is_new = |name: &SmolStr| name == new_name;
    let local = header.locals.iter().any(|local| is_new(&local.name));
    let param = header.params.iter().any(|param| is_new(&param.name));
    if local || param {
        let what = if local { "a local variable" } else { "a parameter" };
        return refused(format!("the program `{}` has {what} called `{new_name}`", header.name));
    }
    Ok(())
}

/// The program does not use global data of the name, which a local would hide.
fn hides_no_data(db: &dyn Db, file: File, new_name: &str) -> Result<(), RenameError> {
    for project in crate::owner::projects_of(db, file) {
        let data = Symbol::Data(*project, new_name.into());
        if items(db, *project).data.contains_key(new_name) && users(db, &data).any(|user| user == file) {
            return refused(format!("the program uses the global `{new_name}`, which the new name would hide"));
        }
    }
    Ok(())
}
