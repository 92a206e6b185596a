//! Names of tasks, which are strings: `taskKill("watch")`.

use val3_analysis::body::{Expr, body};
use val3_analysis::db::{Db, Project};
use val3_analysis::items::program::header;
use val3_analysis::items::project::{items, program_files};
use val3_analysis::occurrences::{Symbol, task_names};
use val3_lang::tasks::{NameFault, name_fault};

use crate::RefactoringError;
use crate::references::uses;

/// Checks that no program computes a task name that may equal `name`.
pub(super) fn check_no_computed_name(db: &dyn Db, project: Project, name: &str) -> Result<(), RefactoringError> {
    for file in program_files(db, project) {
        let body = body(db, *file);
        let names = task_names(body).into_iter().map(|(id, _)| id);
        let mut computed = names.filter(|id| !matches!(body.expr(*id), Expr::String(_)));
        let may_be = computed.any(|id| match body.string(id) {
            Some(whole) => whole == name,
            None => name.starts_with(body.beginning(id).as_str()),
        });
        if may_be {
            let program = &header(db, *file).name;
            return Err(format!("the program `{program}` computes the name of a task, which may be `{name}`").into());
        }
    }
    Ok(())
}

/// Checks that the new name is a valid task name, and that no other task of the project has it.
pub(super) fn check(db: &dyn Db, project: Project, new_name: &str) -> Result<(), RefactoringError> {
    if let Some(fault) = name_fault(new_name, items(db, project).version) {
        return Err(match fault {
            NameFault::Empty => "a task has a name: letters, digits and `_`".into(),
            NameFault::Long(limit) => format!("names of tasks have at most {limit} characters in this version").into(),
            NameFault::Character(_) => format!("`{new_name}` is no name of a task: letters, digits and `_`").into(),
        });
    }
    if uses(db, &Symbol::Task(project, new_name.into())).next().is_some() {
        return Err(format!("there is already a task called `{new_name}`").into());
    }
    check_no_computed_name(db, project, new_name)
}
