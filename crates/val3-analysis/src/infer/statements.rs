//! Inference of statements: expected types of the parts.

use smol_str::SmolStr;
use val3_lang::operators;
use val3_lang::types::{BaseType, Container};

use super::Infer;
use crate::body::{Expr, ExprId, Stmt, StmtKind};
use crate::problem::ProblemKind;
use crate::ty::Base;

pub(super) fn walk_block(infer: &mut Infer<'_>, block: &[Stmt]) {
    for stmt in block {
        walk_stmt(infer, stmt);
    }
}

fn walk_stmt(infer: &mut Infer<'_>, stmt: &Stmt) {
    match &stmt.kind {
        StmtKind::If { arms, otherwise } => if_stmt(infer, arms, otherwise.as_deref()),
        StmtKind::While { condition, block } => {
            check_condition(infer, "while", *condition);
            walk_block(infer, block);
        }
        StmtKind::Do { block, condition } => {
            walk_block(infer, block);
            check_condition(infer, "until", *condition);
        }
        StmtKind::For { counter, start, stop, step, block } => {
            for_counter(infer, *counter);
            for_bound(infer, "=", *start);
            for_bound(infer, "to", *stop);
            for_bound(infer, "step", *step);
            walk_block(infer, block);
        }
        StmtKind::Switch { selector, cases } => switch(infer, *selector, cases),
        StmtKind::Call(call) => infer.call_stmt(*call),
        StmtKind::TaskCreate { synchronous, arguments } => infer.task_create(stmt.range, *synchronous, arguments),
        StmtKind::Print(value) => {
            let shown = infer.expr(*value);
            // The first element of an array is shown. A collection has none without a key.
            if shown.container() == Container::Collection {
                infer.index_missing(*value, &shown);
            }
        }
        StmtKind::Assign { target, value } => {
            infer.assign(*target, *value);
        }
        StmtKind::Expr(id) => expr_stmt(infer, *id),
        StmtKind::Return | StmtKind::Error => {}
    }
}

fn if_stmt(infer: &mut Infer<'_>, arms: &[(Option<ExprId>, Vec<Stmt>)], otherwise: Option<&[Stmt]>) {
    let keywords = std::iter::once("if").chain(std::iter::repeat("elseIf"));
    for ((condition, block), keyword) in arms.iter().zip(keywords) {
        check_condition(infer, keyword, *condition);
        walk_block(infer, block);
    }
    walk_block(infer, otherwise.unwrap_or(&[]));
}

fn check_condition(infer: &mut Infer<'_>, keyword: &'static str, id: Option<ExprId>) {
    let Some(id) = id else { return };
    let found = infer.element(id);
    let is_bool = found.builtin().is_none_or(operators::reads_as_bool) && !matches!(found, Base::User(_));
    if !is_bool {
        let found = infer.scope.show(found);
        infer.report(id, ProblemKind::ConditionType { keyword: SmolStr::new_static(keyword), found });
    }
}

fn for_counter(infer: &mut Infer<'_>, id: Option<ExprId>) {
    let Some(id) = id else { return };
    let value = infer.expr(id);
    if !value.is_variable() || !value.base.same_as(Base::of(BaseType::Num)) {
        let found = if value.is_variable() { infer.scope.show(value.base) } else { SmolStr::new_static("constant") };
        infer.report(id, ProblemKind::ForCounter { found });
    } else if value.lacks_index() {
        infer.index_missing(id, &value);
    }
}

fn for_bound(infer: &mut Infer<'_>, keyword: &'static str, id: Option<ExprId>) {
    let Some(id) = id else { return };
    let found = infer.element(id);
    if !found.same_as(Base::of(BaseType::Num)) {
        let found = infer.scope.show(found);
        infer.report(id, ProblemKind::ForBound { keyword: SmolStr::new_static(keyword), found });
    }
}

fn switch(infer: &mut Infer<'_>, selector: Option<ExprId>, cases: &[(Vec<ExprId>, Vec<Stmt>)]) {
    let mut expected = selector.map_or(Base::Unknown, |id| infer.element(id));
    if let (Base::Builtin(ty, _), Some(id)) = (expected, selector)
        && !operators::comparable(ty, ty)
    {
        let found = infer.scope.show(expected);
        infer.report(id, ProblemKind::SwitchType { found });
        expected = Base::Unknown;
    }
    for (values, block) in cases {
        for value in values {
            case_value(infer, expected, *value);
        }
        walk_block(infer, block);
    }
}

fn case_value(infer: &mut Infer<'_>, expected: Base, id: ExprId) {
    let found = infer.element_as(id, Some(expected));
    let comparable = match (expected, found) {
        (Base::Builtin(a, _), Base::Builtin(b, _)) => operators::comparable(a, b),
        _ => expected.same_as(found),
    };
    if !comparable {
        let [expected, found] = infer.scope.show_both([expected, found]);
        infer.report(id, ProblemKind::CaseType { expected, found });
    }
}

/// Checks that an expression statement has an effect.
fn expr_stmt(infer: &mut Infer<'_>, id: ExprId) {
    if let Expr::Call(callee, args) = infer.body.expr(id) {
        return infer.instruction_stmt(id, *callee, args);
    }
    let before = infer.sink.len();
    infer.expr_as(id, Some(Base::Unknown));
    if infer.sink.len() == before {
        infer.report(id, ProblemKind::NoEffect);
    }
}
