//! Changes the signature of a program: adds, removes, renames, retypes and reorders parameters, in its declaration, its
//! code and all calls of the workspace. Locals are changed in the same way, without calls.

mod arguments;
mod attributes;
mod calls;
mod declarations;
mod names;
mod programs;
mod slots;
mod variables;

pub(crate) use calls::Call;
pub use variables::{NewLocal, NewParameter, NewVariables};

use val3_analysis::application::ENTRY_POINTS;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::declarations::{all_locals, all_params};
use val3_analysis::items::program::header;
use val3_analysis::occurrences::Symbol;
use val3_analysis::pages::{binding_files, bindings};
use val3_analysis::ty::Base;
use val3_syntax::TextRange;

use crate::RefactoringError;
use crate::edit::{FileEdit, SourceChange};
use crate::owner::projects_of;
use crate::references::uses;
use crate::test_programs::is_test;
use programs::AffectedProgram;

/// Changes the parameters and locals of the program in `file`. Arguments in its callers are adapted, and so are the
/// same programs in libraries that are loaded for the same interface.
///
/// # Errors
/// If a removed variable is still used, a name is in use, or a call cannot be adapted; the message gives the reason.
pub fn change_signature(db: &dyn Db, file: File, wanted: &NewVariables) -> Result<SourceChange, RefactoringError> {
    change(db, file, wanted).map(|change| change.sorted(db))
}

fn change(db: &dyn Db, file: File, wanted: &NewVariables) -> Result<SourceChange, RefactoringError> {
    let header = header(db, file);
    if !wanted.is_consistent(header) {
        return Err("the program was changed meanwhile".into());
    }
    let calls_change = !wanted.keeps_arguments(header);
    let are_parameters_same = !calls_change && !wanted.parameters.iter().any(|new| new.is_renamed(header));
    let symbols = if are_parameters_same { Vec::new() } else { programs::symbols(db, file) };
    let programs = programs::programs(db, file, &symbols, wanted)?;
    for program in &programs {
        names::check_readable(db, program)?;
        names::check(db, program)?;
    }
    let mut edits = Vec::new();
    let mut removed = Vec::new();
    let mut renames: Vec<FileEdit> = programs.iter().flat_map(|program| renames(db, program)).collect();
    // The parameter of a test has its own name.
    if !are_parameters_same && let Some(reason) = fixed_parameters(db, file) {
        return Err(reason.into());
    }
    if calls_change {
        wanted.parameters.iter().filter(|new| new.from.is_none()).try_for_each(arguments::check)?;
        for call in calls::calls(db, &symbols, header.params.len())? {
            let new = arguments::edits(db, &call, &wanted.parameters, &renames)?;
            let places = call.places(db);
            renames.retain(|edit| edit.file != call.file || !places.iter().any(|it| it.contains_range(edit.range)));
            removed.extend(new.removed.into_iter().map(|range| (call.file, range)));
            edits.extend(new.edits);
        }
    }
    for program in &programs {
        removed_are_unused(db, program, &removed)?;
        edits.extend(declarations::edits(db, program.file, &program.wanted)?);
    }
    edits.extend(renames);
    Ok(SourceChange::of(edits))
}

/// Reason why the parameters of the program in `file` are fixed: it is not only called by programs. `None` if they can
/// be changed.
pub(crate) fn fixed_parameters(db: &dyn Db, file: File) -> Option<String> {
    let name = &header(db, file).name;
    if ENTRY_POINTS.contains(&name.as_str()) {
        return Some(format!("the controller itself calls `{name}`, without arguments"));
    }
    let projects = projects_of(db, file);
    if projects.iter().any(|project| is_entry_point(db, *project, name)) {
        return Some(format!("`{name}` is an entry point according to `val3.toml`, which is called without arguments"));
    }
    if header(db, file).params.is_empty() && projects.iter().any(|project| is_callback(db, *project, name)) {
        return Some(format!("a user page calls `{name}`, without arguments"));
    }
    let is_test = projects.iter().any(|project| is_test(db, *project, name));
    is_test.then(|| format!("`val3 test` calls `{name}`, with the number of a row as the only possible argument"))
}

/// Whether `val3.toml` declares the program an entry point.
fn is_entry_point(db: &dyn Db, project: Project, program: &str) -> bool {
    project.config(db).is_some_and(|config| config.lint.entry_points.iter().any(|entry| entry == program))
}

/// Whether a user page calls the program.
fn is_callback(db: &dyn Db, project: Project, program: &str) -> bool {
    let mut callbacks = binding_files(db, project).flat_map(|file| &bindings(db, file).callbacks);
    callbacks.any(|callback| callback.program.as_ref().is_some_and(|bound| bound.text == program))
}

/// Whether every call of the program in `file` passes a variable of type `ty` for the parameter, none of them creates a
/// task, and no other program shares the signature.
pub(crate) fn passes_variables(db: &dyn Db, file: File, index: usize, ty: Base) -> bool {
    let symbols = programs::symbols(db, file);
    let is_alone = symbols.len() == projects_of(db, file).len();
    let calls = calls::calls(db, &symbols, header(db, file).params.len());
    is_alone && calls.is_ok_and(|calls| calls.iter().all(|call| call.passes_variable(db, index, ty)))
}

/// Edits that rename variables in the code of a program.
fn renames(db: &dyn Db, program: &AffectedProgram) -> Vec<FileEdit> {
    let (file, header) = (program.file, header(db, program.file));
    let params = program.wanted.parameters.iter().filter_map(|new| {
        let old = header.params.get(new.from?)?;
        (old.name != *new.name).then(|| (Symbol::Param(file, old.name.clone()), &new.name))
    });
    let locals = program.wanted.locals.iter().filter_map(|new| {
        let old = header.locals.get(new.from?)?;
        (old.name != *new.name).then(|| (Symbol::Local(file, old.name.clone()), &new.name))
    });
    let edits = params.chain(locals).flat_map(|(symbol, name)| {
        in_code(db, &symbol).into_iter().map(move |range| FileEdit { file, range, text: name.clone() })
    });
    edits.collect()
}

/// Uses of a parameter or local, without its declaration.
pub(crate) fn in_code(db: &dyn Db, symbol: &Symbol) -> Vec<TextRange> {
    let (Symbol::Param(file, _) | Symbol::Local(file, _)) = symbol else { return Vec::new() };
    let declared = all_params(db, *file).into_iter().chain(all_locals(db, *file));
    let declared: Vec<TextRange> = declared.map(|declared| declared.element).collect();
    let mut found: Vec<TextRange> = uses(db, symbol).map(|(_, _, range)| range).collect();
    found.retain(|range| !declared.iter().any(|element| element.contains_range(*range)));
    found.sort_unstable_by_key(|range| range.start());
    found.dedup();
    found
}

/// Checks that removed parameters and locals are unused, except in arguments that are removed as well.
fn removed_are_unused(
    db: &dyn Db,
    program: &AffectedProgram,
    removed: &[(File, TextRange)],
) -> Result<(), RefactoringError> {
    let (file, header) = (program.file, header(db, program.file));
    let keeps_param = |index: usize| program.wanted.parameters.iter().any(|new| new.from == Some(index));
    let keeps_local = |index: usize| program.wanted.locals.iter().any(|new| new.from == Some(index));
    let params = (0..).zip(&header.params).filter(|(index, _)| !keeps_param(*index));
    let params = params.map(|(_, param)| ("the parameter", &param.name, Symbol::Param(file, param.name.clone())));
    let locals = (0..).zip(&header.locals).filter(|(index, _)| !keeps_local(*index));
    let locals = locals.map(|(_, local)| ("the local variable", &local.name, Symbol::Local(file, local.name.clone())));
    for (what, name, symbol) in params.chain(locals) {
        let mut uses = in_code(db, &symbol);
        uses.retain(|range| !removed.iter().any(|(of, gone)| *of == file && gone.contains_range(*range)));
        let left = uses.len();
        if left > 0 {
            let times = if left == 1 { "once".to_owned() } else { format!("{left} times") };
            return Err(format!("{what} `{name}` is used {times} in `{}`", header.name).into());
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
