//! Programs that share a signature: an interface's program, and the same program in all libraries that are loaded for
//! it.

use smol_str::SmolStr;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::interfaces::is_public;
use val3_analysis::items::program::header;
use val3_analysis::items::project::{items, resolve_type};
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::Base;

use super::variables::{NewParameter, NewVariables};
use crate::RefactoringError;
use crate::owner::{owner, projects_of};
use crate::rename::together;

/// A changed program, with its new variables.
pub(super) struct AffectedProgram {
    pub(super) project: Project,
    pub(super) file: File,
    pub(super) wanted: NewVariables,
}

/// Symbols by which other programs call the program in `file`, for each project that lists it.
pub(super) fn symbols(db: &dyn Db, file: File) -> Vec<Symbol> {
    let name = &header(db, file).name;
    let mut symbols = Vec::new();
    for project in projects_of(db, file) {
        let own = Symbol::Program(*project, name.clone());
        let is_shared = is_public(db, *project, name);
        for symbol in together(db, &own) {
            let is_offered = matches!(&symbol, Symbol::Program(other, _) if is_shared && is_public(db, *other, name));
            if (symbol == own || is_offered) && !symbols.contains(&symbol) {
                symbols.push(symbol);
            }
        }
    }
    symbols
}

/// The programs of these symbols, each with its own variables, changed like the variables of the program in `file`.
///
/// # Errors
/// If one of them has other parameters, or cannot have the new parameters.
pub(super) fn programs(
    db: &dyn Db,
    file: File,
    symbols: &[Symbol],
    wanted: &NewVariables,
) -> Result<Vec<AffectedProgram>, RefactoringError> {
    let project = owner(db, file).ok_or("no project lists the file")?;
    let mut programs = vec![AffectedProgram { project, file, wanted: wanted.clone() }];
    for symbol in symbols {
        let Symbol::Program(_, name) = symbol else { continue };
        let other = of_symbol(db, symbol).filter(|(_, other)| programs.iter().all(|known| known.file != *other));
        let Some((project, other)) = other else { continue };
        let translation = Translation { db, file, project, other };
        let parameters = translation.parameters(&wanted.parameters).map_err(|RefactoringError(reason)| {
            format!("`{}` has the program `{name}` for the same interface, and {reason}", folder(db, project))
        })?;
        let wanted = NewVariables { parameters, ..NewVariables::of(header(db, other)) };
        programs.push(AffectedProgram { project, file: other, wanted });
    }
    Ok(programs)
}

fn of_symbol(db: &dyn Db, symbol: &Symbol) -> Option<(Project, File)> {
    let Symbol::Program(project, name) = symbol else { return None };
    Some((*project, *items(db, *project).programs.get(name)?))
}

/// Project name, for messages.
fn folder(db: &dyn Db, project: Project) -> &str {
    project.manifest(db).path(db).file_stem().unwrap_or("")
}

/// Converts changed parameters to the same changes in another program with the same signature.
struct Translation<'db> {
    db: &'db dyn Db,
    /// File of the program with the changed parameters.
    file: File,
    /// Project of the other program.
    project: Project,
    /// File of the other program.
    other: File,
}

impl Translation<'_> {
    fn parameters(&self, changed: &[NewParameter]) -> Result<Vec<NewParameter>, RefactoringError> {
        let (own, others) = (header(self.db, self.file), header(self.db, self.other));
        if own.params.len() != others.params.len() || !others.complete {
            return Err("its parameters are others or cannot be read".into());
        }
        changed.iter().map(|new| self.parameter(new)).collect()
    }

    fn parameter(&self, new: &NewParameter) -> Result<NewParameter, RefactoringError> {
        let (own, others) = (header(self.db, self.file), header(self.db, self.other));
        let known = new.from.and_then(|index| Some((index, own.params.get(index)?, others.params.get(index)?)));
        let Some((index, old, there)) = known else {
            let type_name = type_name(self.db, self.file, self.project, &new.type_name)?;
            return Ok(NewParameter { type_name, ..new.clone() });
        };
        let mut parameter = NewParameter::kept(index, there);
        if old.name == there.name {
            parameter.name.clone_from(&new.name);
        }
        if old.type_name != *new.type_name {
            parameter.type_name = type_name(self.db, self.file, self.project, &new.type_name)?;
        }
        if new.is_passed_differently(old) {
            (parameter.container, parameter.by_reference) = (new.container, new.by_reference);
        }
        Ok(parameter)
    }
}

/// Name in `project` of a type that the program in `file` uses.
fn type_name(db: &dyn Db, file: File, project: Project, name: &str) -> Result<String, RefactoringError> {
    let base = owner(db, file).and_then(|own| resolve_type(&items(db, own).types, name));
    let Some(Base::User(wanted)) = base else { return Ok(name.to_owned()) };
    let types = &items(db, project).types;
    let mut same: Vec<&SmolStr> = types.iter().filter(|(_, of)| **of == Some(wanted)).map(|(name, _)| name).collect();
    same.sort_unstable();
    let found = same.first().map(ToString::to_string);
    found.ok_or_else(|| format!("its project does not list the user type `{name}`").into())
}
