//! Properties of the control-flow graph's nodes, for lints.

use val3_analysis::body::{Constant, ExprId, Stmt, StmtKind};
use val3_analysis::flow::{FlowNode, FlowNodeId, PerPoint, PointKind};
use val3_lang::instruction::CallClass;

use super::{Call, ProgramView};

impl<'db> ProgramView<'db> {
    /// Instruction calls at a flow node, in evaluation order.
    pub(crate) fn calls_at(&self, id: FlowNodeId) -> &[Call<'db>] {
        self.calls_by_point.get_or_init(|| self.calls_of_points()).at(id)
    }

    fn calls_of_points(&self) -> PerPoint<Call<'db>> {
        let mut calls = PerPoint::with_capacity(self.flow().len(), self.calls().len());
        for (_, point) in self.flow().points() {
            calls.push(point.kind.exprs().flat_map(|id| self.calls_within(id)).copied());
        }
        calls
    }

    /// Instruction calls in an expression, inner calls before outer calls.
    pub(super) fn calls_within(&self, id: ExprId) -> &[Call<'db>] {
        let calls = self.calls();
        let (calls, _) = calls.split_at(calls.partition_point(|call| call.id <= id));
        let first = self.body.within(id).next().unwrap_or(id);
        let inside = calls.iter().rev().take_while(|call| call.id >= first).count();
        calls.split_at(calls.len() - inside).1
    }

    /// Whether only `return` ends a loop with this condition: `while true`, `until false`.
    pub(crate) fn is_endless(&self, condition: ExprId) -> bool {
        matches!(self.text(condition).trim_matches(['(', ')', ' ']), "true" | "false")
    }

    /// An endless loop's condition.
    pub(crate) fn endless_condition(&self, stmt: &Stmt) -> Option<ExprId> {
        let (condition, round) = match &stmt.kind {
            StmtKind::While { condition: Some(condition), .. } => (*condition, true),
            StmtKind::Do { condition: Some(condition), .. } => (*condition, false),
            _ => return None,
        };
        (self.body.constant(condition) == Some(Constant::Bool(round))).then_some(condition)
    }

    /// Whether `branch` of a flow node can be taken, as far as constant conditions show.
    pub(crate) fn is_taken(&self, point: &FlowNode, branch: usize) -> bool {
        let PointKind::Test { condition: Some(condition), .. } = point.kind else { return true };
        match self.body.constant(condition) {
            Some(Constant::Bool(value)) => branch == usize::from(!value),
            _ => true,
        }
    }

    /// Whether the expression can be evaluated twice without a different effect: it has no side effects or waits.
    pub(crate) fn is_pure(&self, id: ExprId) -> bool {
        self.calls_within(id)
            .iter()
            .all(|call| !call.instruction.blocking && call.form.is_some_and(|form| form.class == CallClass::Function))
    }
}
