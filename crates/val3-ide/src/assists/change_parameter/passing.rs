//! Checks whether the passing of a parameter can be changed without an effect on the program and its callers.

use val3_analysis::body::StmtKind;
use val3_analysis::effects::{AccessKind, Effects, RootVariable};
use val3_analysis::items::program::ParamDecl;
use val3_analysis::items::project::resolve_type;
use val3_lang::types::Container;

use crate::assists::context::Context;
use crate::change_signature::passes_variables;
use crate::declare::is_old_program;

/// Whether the passing can be changed: the program only reads the parameter, every caller passes a variable, and no
/// variable can change during the call. Calls that create a task are excluded, because the variable may change before
/// the task starts.
pub(super) fn can_change(context: &Context<'_>, index: usize, param: &ParamDecl) -> bool {
    let base = resolve_type(&context.items().types, &param.type_name);
    let Some(base) = base.filter(|base| base.builtin().is_none_or(|ty| !ty.is_linkable())) else { return false };
    let is_single = param.container == Container::Element && !is_old_program(context.db, context.file);
    is_single && !changes_anything(context) && passes_variables(context.db, context.file, index, base)
}

/// Whether the program writes anything other than its locals, calls a program, or waits while other tasks may write.
fn changes_anything(context: &Context<'_>) -> bool {
    let effects = Effects::new(context.db, context.project, context.file);
    let outer = |root: &RootVariable| !matches!(root, RootVariable::Local(_));
    let calls = |kind: &StmtKind| matches!(kind, StmtKind::Call(_) | StmtKind::TaskCreate { .. });
    effects.all().iter().any(|access| access.kind != AccessKind::Read && outer(&access.root))
        || context.body().stmts().iter().any(|stmt| calls(&stmt.kind))
        || effects.may_wait()
}
