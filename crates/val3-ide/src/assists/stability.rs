//! Checks that an expression's value is unchanged while statements are executed.

use std::collections::BTreeSet;

use val3_analysis::body::{Expr, ExprId, Stmt, StmtKind};
use val3_analysis::effects::{Access, AccessKind, RootVariable};
use val3_analysis::flow::{PointKind, flow};
use val3_lang::instruction::Family;
use val3_lang::types::BaseType;
use val3_syntax::TextRange;

use super::context::Context;
use super::evaluation::Evaluation;

/// Variables that determine an expression's value.
pub(super) struct Dependencies<'c, 'db> {
    context: &'c Context<'db>,
    evaluation: &'c Evaluation<'db>,
    roots: BTreeSet<RootVariable>,
}

impl<'c, 'db> Dependencies<'c, 'db> {
    /// Dependencies of `id`; `None` if its value depends on more than variables, for example the time, the arm or
    /// inputs.
    pub(super) fn of(context: &'c Context<'db>, evaluation: &'c Evaluation<'db>, id: ExprId) -> Option<Self> {
        let mut found = Self { context, evaluation, roots: BTreeSet::new() };
        if evaluation.has_effects(id) {
            return None;
        }
        for part in evaluation.body.within(id) {
            if evaluation.inference.ty(part).base.builtin().is_some_and(BaseType::is_linkable) {
                return None;
            }
            match evaluation.body.expr(part) {
                Expr::Call(..) if !found.computes(part) => return None,
                Expr::Name(_) | Expr::Path { .. } => found.roots.extend(evaluation.effects.root(part)),
                _ => {}
            }
        }
        let is_lent = found.roots.iter().any(|root| found.is_lent_to_task(root));
        (!is_lent).then_some(found)
    }

    /// Whether the instruction computes its result only from its arguments.
    fn computes(&self, call: ExprId) -> bool {
        let families = [Family::Numbers, Family::Bits, Family::Strings];
        self.evaluation.effects.instruction(call).is_some_and(|(it, _)| families.contains(&it.family))
    }

    /// Whether a task receives the variable by reference and may write it at any time.
    fn is_lent_to_task(&self, root: &RootVariable) -> bool {
        let tasks = flow(self.context.db, self.context.file).points();
        let mut tasks = tasks.filter(|(_, point)| matches!(point.kind, PointKind::TaskCreate(_)));
        tasks.any(|(id, _)| {
            let lent = |access: &Access| access.kind == AccessKind::Reference && access.root == *root;
            self.evaluation.effects.at(id).iter().any(lent)
        })
    }

    /// Whether no statement changes the value.
    pub(super) fn survive(&self, stmts: &[Stmt]) -> bool {
        stmts.iter().all(|stmt| self.survive_points(stmt.range, None))
    }

    /// Whether the statement does not change the value before it assigns to its target.
    pub(super) fn survive_reads_of(&self, stmt: &Stmt) -> bool {
        let target = match stmt.kind {
            StmtKind::Assign { target, .. } => Some(target),
            _ => None,
        };
        self.survive_points(stmt.range, target)
    }

    fn survive_points(&self, range: TextRange, target: Option<ExprId>) -> bool {
        let effects = &self.evaluation.effects;
        let points = flow(self.context.db, self.context.file).points();
        let mut inside = points.filter(|(_, point)| range.contains_range(point.range));
        inside.all(|(id, point)| {
            let hands_over = effects.may_wait_at(point) || point.kind.exprs().any(|id| self.loads_library(id));
            let runs_others = match point.kind {
                PointKind::Call(_) | PointKind::TaskCreate(_) => true,
                // A loop often waits for a variable that another task writes.
                PointKind::Test { is_loop: true, .. } | PointKind::ForTest { .. } => true,
                PointKind::Unknown => return false,
                _ => hands_over,
            };
            let is_shared = self.roots.iter().any(|root| self.is_shared(root));
            let mut accesses = effects.at(id).iter().filter(|access| Some(access.id) != target);
            let changes = runs_others && is_shared || accesses.any(|access| self.changes(access));
            !changes
        })
    }

    fn loads_library(&self, id: ExprId) -> bool {
        let effects = &self.evaluation.effects;
        let mut calls = self.evaluation.body.within(id).filter_map(|part| effects.instruction(part));
        calls.any(|(instruction, _)| instruction.family == Family::Libraries)
    }

    fn changes(&self, access: &Access) -> bool {
        access.kind != AccessKind::Read && self.roots.iter().any(|root| self.are_same(root, &access.root))
    }

    /// Whether both may refer to the same variable: a parameter by reference may refer to any shared variable.
    fn are_same(&self, left: &RootVariable, right: &RootVariable) -> bool {
        match (left, right) {
            _ if left == right => true,
            (RootVariable::Item(_, left), RootVariable::Item(_, right)) => left == right,
            (RootVariable::Param(_), _) | (_, RootVariable::Param(_)) => self.is_shared(left) && self.is_shared(right),
            _ => false,
        }
    }

    /// Whether other programs may write the variable.
    fn is_shared(&self, root: &RootVariable) -> bool {
        match root {
            RootVariable::Local(_) => false,
            RootVariable::Param(name) => {
                self.context.header().params.iter().any(|param| param.name == *name && param.by_reference)
            }
            RootVariable::Data(_) | RootVariable::Item(..) => true,
        }
    }
}
