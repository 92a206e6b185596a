//! Conflicts of a new name.

use memchr::memmem;
use val3_analysis::application::ENTRY_POINTS;
use val3_analysis::body::{Expr, body};
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::program::header;
use val3_analysis::items::project::{items, program_files};
use val3_analysis::occurrences::{Symbol, occurrences};
use val3_lang::keywords;
use val3_lang::versions::Version;

use super::{elements, tasks};
use crate::RefactoringError;
use crate::references::{text, uses};

fn refused(reason: String) -> Result<(), RefactoringError> {
    Err(RefactoringError(reason))
}

/// Checks that the files declare the name, and that nothing outside them depends on it.
pub(super) fn check_renamable(db: &dyn Db, symbol: &Symbol) -> Result<(), RefactoringError> {
    let name = text(symbol);
    match symbol {
        Symbol::Program(_, name) if ENTRY_POINTS.contains(&name.as_str()) => {
            refused(format!("the controller itself calls `{name}`"))
        }
        Symbol::Program(project, name) if is_called_from_outside(db, *project, name) => {
            refused(format!("`{name}` is an entry point according to `val3.toml`"))
        }
        Symbol::Local(..)
        | Symbol::Param(..)
        | Symbol::Data(..)
        | Symbol::Program(..)
        | Symbol::Library(..)
        | Symbol::Type(..) => Ok(()),
        Symbol::Task(project, name) => tasks::check_no_computed_name(db, *project, name),
        Symbol::Element(page, id) => elements::check_no_other_use(db, *page, id),
        Symbol::Instruction(_)
        | Symbol::Builtin(_)
        | Symbol::Enumerator(_)
        | Symbol::Field(..)
        | Symbol::BuiltinType(_) => refused(format!("`{name}` belongs to the language")),
    }
}

/// Whether the settings name the program as an entry point.
fn is_called_from_outside(db: &dyn Db, project: Project, name: &str) -> bool {
    project.config(db).is_some_and(|config| config.lint.entry_points.iter().any(|entry| entry == name))
}

/// Checks that the new name is valid and unused, and that all uses keep their meaning.
pub(super) fn check(db: &dyn Db, symbols: &[Symbol], new_name: &str) -> Result<(), RefactoringError> {
    symbols.iter().try_for_each(|symbol| {
        check_valid_name(db, symbol, new_name)?;
        check_unused(db, symbol, new_name)
    })
}

/// Reason why an item in an application of this version cannot have the name; `None` if it can.
pub(crate) fn name_fault(name: &str, version: Option<Version>) -> Option<String> {
    if !keywords::is_identifier(name) {
        return Some(format!("`{name}` is no name: letters, digits and `_`, no digit first"));
    }
    if keywords::reserved(name).is_some() {
        return Some(format!("`{}` is a word of the language", keywords::canonical(name).unwrap_or(name)));
    }
    let limit = version.and_then(Version::identifier_limit).filter(|limit| name.len() > *limit)?;
    Some(format!("names have at most {limit} characters in this version"))
}

/// Checks that an item of the symbol's project can have the name.
fn check_valid_name(db: &dyn Db, symbol: &Symbol, name: &str) -> Result<(), RefactoringError> {
    let version = project_of(db, symbol).map(|project| items(db, project).version);
    name_fault(name, version).map_or(Ok(()), refused)
}

/// Checks that a new parameter or local of the program in `file` can have the name, regardless of the other variables.
pub(crate) fn check_variable_name(db: &dyn Db, file: File, name: &str) -> Result<(), RefactoringError> {
    let symbol = Symbol::Local(file, name.into());
    check_valid_name(db, &symbol, name)?;
    check_no_item(db, &symbol, name)?;
    check_hides_no_data(db, file, name)
}

/// Project to which a symbol belongs.
fn project_of(db: &dyn Db, symbol: &Symbol) -> Option<Project> {
    match symbol {
        Symbol::Local(file, _) | Symbol::Param(file, _) => crate::owner::owner(db, *file),
        Symbol::Data(project, _) | Symbol::Program(project, _) => Some(*project),
        Symbol::Library(project, _) | Symbol::Type(project, _) => Some(*project),
        _ => None,
    }
}

/// Checks that the name is unused where the symbol is visible, and unresolved nowhere.
fn check_unused(db: &dyn Db, symbol: &Symbol, new_name: &str) -> Result<(), RefactoringError> {
    check_no_item(db, symbol, new_name)?;
    match symbol {
        Symbol::Local(file, _) | Symbol::Param(file, _) => {
            check_not_declared(db, *file, new_name)?;
            check_hides_no_data(db, *file, new_name)?;
            check_no_unresolved_use(db, *file, new_name)
        }
        // A local hides only data in the same project: `:` precedes a library item, and `.` precedes a field.
        Symbol::Data(project, _) | Symbol::Program(project, _) | Symbol::Library(project, _) => {
            let own = |file: &File| crate::owner::projects_of(db, *file).contains(project);
            users(db, symbol).filter(own).try_for_each(|file| check_not_declared(db, file, new_name))?;
            program_files(db, *project).iter().try_for_each(|file| check_no_unresolved_use(db, *file, new_name))
        }
        _ => Ok(()),
    }
}

/// Checks that no other item in the symbol's project has the name.
fn check_no_item(db: &dyn Db, symbol: &Symbol, new_name: &str) -> Result<(), RefactoringError> {
    let other = project_of(db, symbol).and_then(|project| other_item(db, project, symbol, new_name));
    other.map_or(Ok(()), |what| refused(format!("there is already {what} called `{new_name}`")))
}

/// Kind of the other item in the project with this name; `None` if the name is unused. Program files are compared
/// without letter case. A local variable may have the same name as data, which it then hides.
pub(crate) fn other_item(db: &dyn Db, project: Project, symbol: &Symbol, new_name: &str) -> Option<&'static str> {
    let items = items(db, project);
    let is_local = matches!(symbol, Symbol::Local(..) | Symbol::Param(..));
    let file = format!("{new_name}.pgx");
    let mut other_programs =
        items.programs.keys().filter(|known| !matches!(symbol, Symbol::Program(_, old) if old == *known));
    let moves = matches!(symbol, Symbol::Program(_, old) if !old.eq_ignore_ascii_case(new_name));
    if items.data.contains_key(new_name) && !is_local {
        Some("data")
    } else if other_programs.any(|known| known.eq_ignore_ascii_case(new_name)) {
        Some("a program")
    } else if moves && project.beside(db).iter().any(|beside| beside.eq_ignore_ascii_case(&file)) {
        Some("a file of a program")
    } else if items.libraries.contains_key(new_name) {
        Some("a library identifier")
    } else {
        items.types.contains_key(new_name).then_some("a user type")
    }
}

/// Files that use a symbol.
fn users(db: &dyn Db, symbol: &Symbol) -> impl Iterator<Item = File> {
    let mut files: Vec<File> = uses(db, symbol).map(|(file, ..)| file).collect();
    files.dedup();
    files.into_iter()
}

/// Checks that no local or parameter of the program has the name, because it would hide or duplicate the renamed
/// symbol.
fn check_not_declared(db: &dyn Db, file: File, new_name: &str) -> Result<(), RefactoringError> {
    let header = header(db, file);
    let local = header.locals.iter().any(|local| local.name == new_name);
    let param = header.params.iter().any(|param| param.name == new_name);
    if local || param {
        let what = if local { "a local variable" } else { "a parameter" };
        return refused(format!("the program `{}` has {what} called `{new_name}`", header.name));
    }
    Ok(())
}

/// Checks that the program does not use global data of this name, which a local would hide.
fn check_hides_no_data(db: &dyn Db, file: File, new_name: &str) -> Result<(), RefactoringError> {
    for project in crate::owner::projects_of(db, file) {
        let data = Symbol::Data(*project, new_name.into());
        if items(db, *project).data.contains_key(new_name) && users(db, &data).any(|user| user == file) {
            return refused(format!("the program uses the global `{new_name}`, which the new name would hide"));
        }
    }
    Ok(())
}

/// Checks that the program has no unresolved use of `new_name`, which would resolve to the renamed symbol afterwards.
pub(crate) fn check_no_unresolved_use(db: &dyn Db, file: File, new_name: &str) -> Result<(), RefactoringError> {
    if memmem::find(file.text(db).as_bytes(), new_name.as_bytes()).is_none() {
        return Ok(());
    }
    let Some(project) = crate::owner::owner(db, file) else { return Ok(()) };
    let known = occurrences(db, project, file);
    let mut uses = body(db, file).exprs().filter(|(_, expr, _)| matches!(expr, Expr::Name(name) if name == new_name));
    if uses.any(|(.., range)| known.binary_search_by_key(&range.start(), |found| found.range.start()).is_err()) {
        let program = &header(db, file).name;
        return refused(format!("the program `{program}` uses the name `{new_name}`, which is unresolved"));
    }
    Ok(())
}
