//! Checks of the names, types and sizes of a program's new parameters and locals.

use rustc_hash::FxHashSet;
use val3_analysis::db::Db;
use val3_analysis::items::parse;
use val3_analysis::items::program::{Header, LocalDecl, ParamDecl, header};
use val3_analysis::items::project::{items, resolve_type};
use val3_analysis::ty::Base;
use val3_lang::types::Container;

use super::programs::AffectedProgram;
use super::variables::{NewLocal, NewParameter, NewVariables, has_sizes};
use crate::RefactoringError;
use crate::declare::is_old_program;
use crate::rename::{check_no_unresolved_use, check_variable_name};

/// Checks that the new variables have valid names and types.
pub(super) fn check(db: &dyn Db, program: &AffectedProgram) -> Result<(), RefactoringError> {
    let header = header(db, program.file);
    check_distinct_names(program)?;
    for new in &program.wanted.parameters {
        let old = new.from.and_then(|index| header.params.get(index));
        check_name(db, program, &new.name, old.map(|old| old.name.as_str()))?;
        check_parameter_type(db, program, new, old)?;
    }
    for new in &program.wanted.locals {
        let old = new.from.and_then(|index| header.locals.get(index));
        check_name(db, program, &new.name, old.map(|old| old.name.as_str()))?;
        check_local_type(db, program, new, old)?;
    }
    Ok(())
}

/// Checks that no two variables have the same name.
fn check_distinct_names(program: &AffectedProgram) -> Result<(), RefactoringError> {
    let mut seen = FxHashSet::default();
    match program.wanted.names().find(|name| !seen.insert(*name)) {
        Some(name) => Err(format!("two variables of the program would be called `{name}`").into()),
        None => Ok(()),
    }
}

fn check_name(db: &dyn Db, program: &AffectedProgram, name: &str, old: Option<&str>) -> Result<(), RefactoringError> {
    if old == Some(name) {
        return Ok(());
    }
    check_variable_name(db, program.file, name)?;
    // An added variable may resolve an unresolved name of the program.
    if old.is_some() { check_no_unresolved_use(db, program.file, name) } else { Ok(()) }
}

fn check_parameter_type(
    db: &dyn Db,
    program: &AffectedProgram,
    new: &NewParameter,
    old: Option<&ParamDecl>,
) -> Result<(), RefactoringError> {
    if old.is_some_and(|old| !new.is_retyped(old)) {
        return Ok(());
    }
    if old.is_none_or(|old| old.type_name != *new.type_name) {
        check_type_exists(db, program, &new.type_name)?;
    }
    let name = &new.name;
    match new.container {
        Container::Element => Ok(()),
        _ if !new.by_reference => {
            Err(format!("arrays and collections are passed by reference, and so is `{name}`").into())
        }
        Container::Array { dims: 0 | 4.. } => Err(format!("`{name}` has one to three dimensions").into()),
        Container::Array { dims: 2.. } | Container::Collection if is_old_program(db, program.file) => {
            Err(format!("programs of s5 and s6 have no collections and arrays of one dimension, and so has `{name}`")
                .into())
        }
        _ => Ok(()),
    }
}

fn check_local_type(
    db: &dyn Db,
    program: &AffectedProgram,
    new: &NewLocal,
    old: Option<&LocalDecl>,
) -> Result<(), RefactoringError> {
    if old.is_some_and(|old| !new.is_retyped(old)) {
        return Ok(());
    }
    if old.is_none_or(|old| old.type_name != *new.type_name) {
        check_type_exists(db, program, &new.type_name)?;
    }
    let is_resized = old.is_none_or(|old| old.sizes != new.sizes);
    if is_resized && old.is_some_and(|old| !has_sizes(old)) {
        return Err(format!("`{}` is a collection, which has no size", new.name).into());
    }
    if is_resized && new.sizes.len() > 1 && is_old_program(db, program.file) {
        return Err(format!("arrays of programs of s5 and s6 have one dimension, and so has `{}`", new.name).into());
    }
    if is_resized && (new.sizes.contains(&0) || !(1..=3).contains(&new.sizes.len())) {
        return Err(format!("`{}` has one to three dimensions, each with at least one value", new.name).into());
    }
    Ok(())
}

/// Checks that the name of a type can be resolved.
fn check_type_exists(db: &dyn Db, program: &AffectedProgram, name: &str) -> Result<(), RefactoringError> {
    match resolve_type(&items(db, program.project).types, name) {
        None => Err(format!("there is no type `{name}`").into()),
        Some(Base::Unknown) => Err(format!("the project of the user type `{name}` cannot be found").into()),
        Some(_) => Ok(()),
    }
}

/// Checks that all declarations of a program can be read, and if names are removed or changed, also that its code has
/// no syntax errors.
pub(super) fn check_readable(db: &dyn Db, program: &AffectedProgram) -> Result<(), RefactoringError> {
    let header = header(db, program.file);
    let path = program.file.path(db).file_name().unwrap_or("");
    if !header.complete {
        return Err(format!("the parameters and locals of `{path}` cannot be read").into());
    }
    if keeps_names(&program.wanted, header) || parse(db, program.file).errors().is_empty() {
        return Ok(());
    }
    Err(format!("`{path}` has syntax errors, so some uses of its variables may be missing").into())
}

/// Whether every variable is kept with its name.
fn keeps_names(wanted: &NewVariables, header: &Header) -> bool {
    let parameters: FxHashSet<_> = wanted.parameters.iter().map(|new| (new.from, new.name.as_str())).collect();
    let locals: FxHashSet<_> = wanted.locals.iter().map(|new| (new.from, new.name.as_str())).collect();
    (0..).zip(&header.params).all(|(index, old)| parameters.contains(&(Some(index), old.name.as_str())))
        && (0..).zip(&header.locals).all(|(index, old)| locals.contains(&(Some(index), old.name.as_str())))
}
