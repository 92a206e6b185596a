//! Statements: which types their parts need.

use smol_str::SmolStr;
use val3_lang::operators;
use val3_lang::types::BaseType;

use super::Infer;
use crate::body::{Expr, ExprId, Stmt, StmtKind};
use crate::problem::ProblemKind;
use crate::ty::Base;

impl Infer<'_> {
    pub(super) fn block(&mut self, block: &[Stmt]) {
        for stmt in block {
            self.stmt(stmt);
        }
    }

    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::If { arms, otherwise } => self.if_stmt(arms, otherwise.as_deref()),
            StmtKind::While { condition, block } => {
                self.condition("while", *condition);
                self.block(block);
            }
            StmtKind::Do { block, condition } => {
                self.block(block);
                self.condition("until", *condition);
            }
            StmtKind::For { counter, start, stop, step, block } => {
                self.for_counter(*counter);
                self.for_bound("=", *start);
                self.for_bound("to", *stop);
                self.for_bound("step", *step);
                self.block(block);
            }
            StmtKind::Switch { selector, cases } => self.switch(*selector, cases),
            StmtKind::Call(call) => self.call_stmt(*call),
            StmtKind::TaskCreate { synchronous, arguments } => self.task_create(stmt.range, *synchronous, arguments),
            StmtKind::Print(value) => {
                self.expr(*value);
            }
            StmtKind::Assign { target, value } => {
                self.assign(*target, *value);
            }
            StmtKind::Expr(id) => self.expr_stmt(*id),
            StmtKind::Return | StmtKind::Error => {}
        }
    }

    fn if_stmt(&mut self, arms: &[(Option<ExprId>, Vec<Stmt>)], otherwise: Option<&[Stmt]>) {
        let keywords = std::iter::once("if").chain(std::iter::repeat("elseIf"));
        for ((condition, block), keyword) in arms.iter().zip(keywords) {
            self.condition(keyword, *condition);
            self.block(block);
        }
        self.block(otherwise.unwrap_or(&[]));
    }

    fn condition(&mut self, keyword: &'static str, id: Option<ExprId>) {
        let Some(id) = id else { return };
        let found = self.element(id);
        let is_bool = found.builtin().is_none_or(operators::reads_as_bool) && !matches!(found, Base::User(_));
        if !is_bool {
            let found = self.show(found);
            self.report(id, ProblemKind::ConditionType { keyword: SmolStr::new_static(keyword), found });
        }
    }

    fn for_counter(&mut self, id: Option<ExprId>) {
        let Some(id) = id else { return };
        let value = self.expr(id);
        if !value.is_variable() || !value.base.same_as(Base::of(BaseType::Num)) {
            let found = if value.is_variable() { self.show(value.base) } else { SmolStr::new_static("constant") };
            self.report(id, ProblemKind::ForCounter { found });
        } else if value.lacks_index() {
            self.index_missing(id, &value);
        }
    }

    fn for_bound(&mut self, keyword: &'static str, id: Option<ExprId>) {
        let Some(id) = id else { return };
        let found = self.element(id);
        if !found.same_as(Base::of(BaseType::Num)) {
            let found = self.show(found);
            self.report(id, ProblemKind::ForBound { keyword: SmolStr::new_static(keyword), found });
        }
    }

    fn switch(&mut self, selector: Option<ExprId>, cases: &[(Vec<ExprId>, Vec<Stmt>)]) {
        let mut expected = selector.map_or(Base::Unknown, |id| self.element(id));
        if let (Base::Builtin(ty, _), Some(id)) = (expected, selector)
            && !operators::comparable(ty, ty)
        {
            let found = self.show(expected);
            self.report(id, ProblemKind::SwitchType { found });
            expected = Base::Unknown;
        }
        for (values, block) in cases {
            for value in values {
                self.case_value(expected, *value);
            }
            self.block(block);
        }
    }

    fn case_value(&mut self, expected: Base, id: ExprId) {
        let found = self.element_as(id, Some(expected));
        let comparable = match (expected, found) {
            (Base::Builtin(a, _), Base::Builtin(b, _)) => operators::comparable(a, b),
            _ => expected.same_as(found),
        };
        if !comparable {
            let (expected, found) = (self.show(expected), self.show(found));
            self.report(id, ProblemKind::CaseType { expected, found });
        }
    }

    /// An expression alone on its line must act.
    fn expr_stmt(&mut self, id: ExprId) {
        if let Expr::Call(callee, args) = self.body.expr(id) {
            return self.instruction_stmt(id, *callee, args);
        }
        let before = self.problems.len();
        self.expr_as(id, Some(Base::Unknown));
        if self.problems.len() == before {
            self.report(id, ProblemKind::NoEffect);
        }
    }
}
