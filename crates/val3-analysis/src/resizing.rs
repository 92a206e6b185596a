//! Data whose size may change while the application runs.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_lang::instruction::ArgumentForm;
use val3_lang::instructions;

use crate::body::{Body, Expr, ExprId, body};
use crate::db::{Db, File, Project};
use crate::items::project::program_files;

/// Whether a program of the project may change the size of the data called `name`.
pub fn is_resized(db: &dyn Db, project: Project, name: &str) -> bool {
    resized_data(db, project).contains(name)
}

#[salsa::tracked]
fn resized_data(db: &dyn Db, project: Project) -> FxHashSet<SmolStr> {
    program_files(db, project).iter().flat_map(|file| resized(db, *file)).cloned().collect()
}

/// Returns the variables that a program passes as whole containers, so that instructions (`insert`, `resize`, `libList`
/// …) and programs may change their size. A start element of a part counts as the whole container.
#[salsa::tracked]
fn resized(db: &dyn Db, file: File) -> FxHashSet<SmolStr> {
    let body = body(db, file);
    let mut names = FxHashSet::default();
    for (_, expr, _) in body.exprs() {
        if let Expr::Call(callee, args) = expr {
            let handed_over = args.iter().enumerate().filter(|(position, _)| takes_container(body, *callee, *position));
            names.extend(handed_over.filter_map(|(_, id)| variable(body, *id)));
        }
    }
    names
}

/// Whether the parameter may be a container whose size changes: always for a program, and for an instruction that may
/// change sizes.
fn takes_container(body: &Body, callee: ExprId, position: usize) -> bool {
    let instruction = match body.expr(callee) {
        Expr::Name(name) => instructions::find(name),
        _ => None,
    };
    instruction.is_none_or(|instruction| {
        let params = instruction.overloads.iter().filter_map(|form| form.params.get(position));
        instructions::may_resize(instruction) && params.into_iter().any(|param| param.shape != ArgumentForm::Value)
    })
}

fn variable(body: &Body, id: ExprId) -> Option<SmolStr> {
    match body.expr(id) {
        Expr::Name(name) => Some(name.clone()),
        Expr::Index(base, _) => variable(body, *base),
        _ => None,
    }
}
