//! Side effects of expressions.

use val3_analysis::body::{Expr, ExprId, body};
use val3_analysis::db::{Db, File, Project};
use val3_analysis::infer::infer;

/// Reason why an expression may not be evaluated for display; `None` if it has no side effect.
pub(super) fn effect(db: &dyn Db, project: Project, file: File, id: ExprId) -> Option<String> {
    let (body, types) = (body(db, file), infer(db, project, file));
    body.within(id).find_map(|id| match body.expr(id) {
        Expr::Assign(..) => Some("an assignment changes a variable; use `==` to compare".to_owned()),
        Expr::Call(..) => {
            let call = types.call(id);
            if call.is_some_and(|call| call.form.is_some_and(|form| !call.instruction.has_effects(form))) {
                return None;
            }
            let name = call.map(|call| call.instruction.name);
            let name = name.or_else(|| types.add_on_call(id).map(|call| call.name.as_str()));
            Some(format!("`{}` has side effects; execute it in the debug console", name.unwrap_or("call")))
        }
        _ => None,
    })
}
