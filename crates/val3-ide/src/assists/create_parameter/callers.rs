//! Arguments for a new parameter in the calls of a program.

use val3_analysis::db::{Db, File, Project};
use val3_analysis::interfaces::is_public;
use val3_analysis::items::program::header;
use val3_analysis::items::project::{items, resolve_type};
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::{Base, Ty};
use val3_lang::types::{BaseType, Container};
use val3_syntax::TextRange;

use super::super::context::Context;
use super::super::expected::UnknownName;
use crate::RefactoringError;
use crate::change_signature::Call;
use crate::edit::FileEdit;
use crate::navigate::{implemented, implementing};
use crate::owner::projects_of;
use crate::references::uses;
use crate::xml_list::escaped;

/// New arguments of the calls.
#[derive(Debug, Default)]
pub(super) struct CallArguments {
    /// Edits that add an argument to each call.
    pub(super) edits: Vec<FileEdit>,
    /// Default argument for calls in programs that have no suitable variable of this name.
    pub(super) default: Option<&'static str>,
}

/// Adds an argument to each call of the program.
///
/// # Errors
/// A reason for the user, if a call has nothing to pass, or if another program must have the same parameters.
pub(super) fn pass(
    context: &Context<'_>,
    unknown: &UnknownName,
    by_reference: bool,
) -> Result<CallArguments, RefactoringError> {
    let name = &context.header().name;
    let mut passed = CallArguments::default();
    for project in projects_of(context.db, context.file) {
        same_elsewhere(context.db, *project, name)?;
        let symbol = Symbol::Program(*project, name.clone());
        for (file, user, range) in uses(context.db, &symbol) {
            let Some(call) = Call::at(context.db, file, user, range)? else { continue };
            let argument = match is_available(context, unknown, file, user) {
                true => unknown.name.as_str(),
                false => default(unknown.ty(), by_reference)
                    .inspect(|value| passed.default = Some(value))
                    .ok_or_else(|| format!("the caller `{}` has no value to pass", header(context.db, file).name))?,
            };
            let edit = with(&call, argument);
            if !passed.edits.contains(&edit) {
                passed.edits.push(edit);
            }
        }
    }
    Ok(passed)
}

/// Checks that no library or interface requires another program with the same parameters.
fn same_elsewhere(db: &dyn Db, project: Project, name: &str) -> Result<(), RefactoringError> {
    let others = implemented(db, project).chain(implementing(db, project));
    let other = others.into_iter().find(|other| items(db, *other).programs.contains_key(name));
    match other.filter(|_| is_public(db, project, name)) {
        Some(other) => {
            let other = other.manifest(db).path(db).file_stem().unwrap_or("");
            Err(format!("`{other}` has the same program, because both implement one interface").into())
        }
        None => Ok(()),
    }
}

/// Whether the calling program has a suitable variable of this name. In a recursive call it is the new parameter.
fn is_available(context: &Context<'_>, unknown: &UnknownName, file: File, user: Project) -> bool {
    let db = context.db;
    if file == context.file {
        return true;
    }
    let header = header(db, file);
    let locals = header.locals.iter().map(|local| (&local.name, &local.type_name, local.container));
    let params = header.params.iter().map(|param| (&param.name, &param.type_name, param.container));
    let mut named = locals.chain(params).filter(|(name, ..)| **name == unknown.name);
    named.any(|(_, type_name, container)| {
        resolve_type(&items(db, user).types, type_name).is_some_and(|base| suits(unknown.ty(), base, container))
    })
}

/// Whether a variable has the type that the unknown name must have.
fn suits(expected: Ty, base: Base, container: Container) -> bool {
    let is_array = matches!(expected.container, Container::Array { .. } | Container::Collection);
    base.same_as(expected.base) && (!is_array || container == expected.container)
}

/// Literal that is passed for a single value; `None` if a variable is required.
fn default(ty: Ty, by_reference: bool) -> Option<&'static str> {
    if by_reference || ty.container != Container::Element {
        return None;
    }
    match ty.base.builtin()? {
        BaseType::Num => Some("0"),
        BaseType::Bool => Some("false"),
        BaseType::String => Some("\"\""),
        _ => None,
    }
}

/// Edit that appends an argument to a call.
fn with(call: &Call, argument: &str) -> FileEdit {
    let argument = if call.is_escaped { escaped(argument) } else { argument.to_owned() };
    let text = if call.has_arguments() { format!(",{argument}") } else { argument };
    FileEdit { file: call.file, range: TextRange::empty(call.end), text }
}
