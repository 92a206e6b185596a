//! Task names, which are strings: `taskCreate "watch",10,watch()`, `taskKill("watch")`.

use val3_lang::instructions::ON_TASKS;

use super::occurrence::Usage;
use crate::body::{Body, Expr, ExprId, StmtKind};

/// Returns the arguments in a program that name a task. The name in `taskCreate` is the declaration.
pub fn task_names(body: &Body) -> Vec<(ExprId, Usage)> {
    let created = body.stmts().into_iter().filter_map(|stmt| match &stmt.kind {
        StmtKind::TaskCreate { arguments, .. } => arguments.first().map(|name| (*name, Usage::Declaration)),
        _ => None,
    });
    let named = body.exprs().filter_map(|(_, expr, _)| match expr {
        Expr::Call(callee, arguments) if is_on_tasks(body, *callee) => Some((*arguments.first()?, Usage::Read)),
        _ => None,
    });
    created.chain(named).collect()
}

fn is_on_tasks(body: &Body, callee: ExprId) -> bool {
    matches!(body.expr(callee), Expr::Name(name) if ON_TASKS.contains(&name.as_str()))
}
