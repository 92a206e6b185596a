//! Construction of the guards: a walk over the blocks that keeps the current guard.

use super::{Guard, GuardId, GuardNode, GuardedExpr, Guards, decisive_operand};
use crate::body::{Body, Constant, Expr, ExprId, Stmt, StmtKind};

/// Conditions and blocks of `if` and `elseIf`.
type Arms = [(Option<ExprId>, Vec<Stmt>)];

struct Builder<'b> {
    body: &'b Body,
    guards: Guards,
    /// Guard of the next statement.
    guard: Option<GuardId>,
}

/// Whether the end of a block is reached.
#[derive(Clone, Copy, PartialEq)]
enum BlockEnd {
    Reached,
    /// The block ends with a `return` or an endless loop.
    NotReached,
}

pub(super) fn build(body: &Body) -> Guards {
    let mut builder = Builder { body, guards: Guards::default(), guard: None };
    builder.block(&body.block, None);
    builder.guards.exprs.sort_unstable_by_key(|expr| expr.whole);
    builder.guards.exprs.shrink_to_fit();
    builder.guards.nodes.shrink_to_fit();
    builder.guards
}

impl Builder<'_> {
    /// Adds the guards of a block. `guard` is the guard of the block, in addition to the current guard.
    fn block(&mut self, block: &[Stmt], guard: Option<Guard>) -> BlockEnd {
        let outer = self.guard;
        if let Some(guard) = guard {
            self.require(guard);
        }
        let mut end = BlockEnd::Reached;
        for stmt in block {
            if self.stmt(stmt) == BlockEnd::NotReached && end == BlockEnd::Reached {
                end = BlockEnd::NotReached;
                self.require(Guard::Never);
            }
        }
        self.guard = outer;
        end
    }

    /// Adds a guard for everything up to the end of the current block.
    fn require(&mut self, guard: Guard) {
        self.guard = Some(self.add(guard, self.guard));
    }

    fn add(&mut self, guard: Guard, outer: Option<GuardId>) -> GuardId {
        let is_never_met = self.guards.node(outer).is_some_and(|node| node.is_never_met)
            || guard.is_met(self.body, &|_| None) == Some(false);
        let id = GuardId(u32::try_from(self.guards.nodes.len()).unwrap_or(u32::MAX));
        self.guards.nodes.push(GuardNode { guard, outer, is_never_met });
        id
    }

    fn stmt(&mut self, stmt: &Stmt) -> BlockEnd {
        match &stmt.kind {
            StmtKind::If { arms, otherwise } => return self.if_stmt(arms, otherwise.as_deref()),
            StmtKind::While { condition, block } => {
                self.exprs(*condition);
                self.block(block, condition.map(|condition| Guard::Condition(condition, true)));
                return self.end_of_loop(*condition, false);
            }
            StmtKind::Do { block, condition } => {
                if self.block(block, None) == BlockEnd::NotReached {
                    self.require(Guard::Never);
                    self.exprs(*condition);
                    return BlockEnd::NotReached;
                }
                self.exprs(*condition);
                return self.end_of_loop(*condition, true);
            }
            StmtKind::For { counter, start, stop, step, block } => {
                self.exprs([*counter, *start, *stop, *step].into_iter().flatten());
                self.block(block, Some(Guard::Loop { counter: *counter, bounds: [*start, *stop, *step] }));
            }
            StmtKind::Switch { selector, cases } => return self.switch(*selector, cases),
            StmtKind::Return => return BlockEnd::NotReached,
            _ => self.exprs(stmt.kind.exprs()),
        }
        BlockEnd::Reached
    }

    /// Adds the guard of the lines after a loop, which ends when its condition has this value.
    fn end_of_loop(&mut self, condition: Option<ExprId>, value: bool) -> BlockEnd {
        let Some(condition) = condition else { return BlockEnd::Reached };
        if self.body.constant(condition) == Some(Constant::Bool(!value)) {
            return BlockEnd::NotReached;
        }
        self.require(Guard::Condition(condition, value));
        BlockEnd::Reached
    }

    /// The lines after an `if` are guarded by the conditions that all ways to them have in common: if every block up to
    /// one is left, then the conditions before it are false.
    fn if_stmt(&mut self, arms: &Arms, otherwise: Option<&[Stmt]>) -> BlockEnd {
        let outer = self.guard;
        let mut ends = Vec::with_capacity(arms.len() + 1);
        for (condition, block) in arms {
            self.exprs(*condition);
            ends.push(self.block(block, condition.map(|condition| Guard::Condition(condition, true))));
            if let Some(condition) = condition {
                self.require(Guard::Condition(*condition, false));
            }
        }
        ends.push(self.block(otherwise.unwrap_or(&[]), None));
        self.guard = outer;
        let Some(first) = ends.iter().position(|end| *end == BlockEnd::Reached) else { return BlockEnd::NotReached };
        for (condition, _) in arms.iter().take(first) {
            condition.iter().for_each(|condition| self.require(Guard::Condition(*condition, false)));
        }
        let is_only = ends.iter().filter(|end| **end == BlockEnd::Reached).count() == 1;
        if let Some((Some(condition), _)) = arms.get(first).filter(|_| is_only) {
            self.require(Guard::Condition(*condition, true));
        }
        BlockEnd::Reached
    }

    fn switch(&mut self, selector: Option<ExprId>, cases: &[(Vec<ExprId>, Vec<Stmt>)]) -> BlockEnd {
        self.exprs(selector.into_iter().chain(cases.iter().flat_map(|(values, _)| values).copied()));
        let mut is_left = cases.iter().any(|(values, _)| values.is_empty());
        for (values, block) in cases {
            let guard = selector.map(|selector| Guard::Case(selector, values.clone()));
            is_left &= self.block(block, guard) == BlockEnd::NotReached;
        }
        if is_left { BlockEnd::NotReached } else { BlockEnd::Reached }
    }

    /// Adds expressions with the current guard, and the right operands in them that are not always evaluated.
    fn exprs(&mut self, exprs: impl IntoIterator<Item = ExprId>) {
        for whole in exprs {
            let first = self.body.first_within(whole);
            self.guards.exprs.push(GuardedExpr { first, whole, guard: self.guard });
            self.right_operands(whole);
        }
    }

    fn right_operands(&mut self, whole: ExprId) {
        let body = self.body;
        // Expressions around the current one: the list goes from the outside to the inside.
        let mut around: Vec<GuardedExpr> = Vec::new();
        for id in body.within(whole).rev() {
            while around.last().is_some_and(|expr| id < expr.first) {
                around.pop();
            }
            let Expr::Binary(op, left, right) = body.expr(id) else { continue };
            let Some(decisive) = decisive_operand(*op) else { continue };
            let outer = around.last().map_or(self.guard, |expr| expr.guard);
            let guard = Some(self.add(Guard::Condition(*left, !decisive), outer));
            let operand = GuardedExpr { first: body.first_within(*right), whole: *right, guard };
            self.guards.exprs.push(operand);
            around.push(operand);
        }
    }
}
