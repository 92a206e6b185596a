//! Flags that a program tests on one line and sets on the next, as an unsafe lock.
//!
//! Tasks switch between lines (5.4), so two tasks may both find the flag free. `setMutex` tests and sets within one
//! line (5.9).

use smol_str::SmolStr;
use val3_lang::instructions::WAIT;
use val3_lang::operators::{BinaryOp, UnaryOp};
use val3_syntax::TextRange;

use crate::body::{Body, Constant, Expr, ExprId, Stmt, StmtKind};

/// A flag that is used as a lock.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Lock {
    /// Variable name.
    pub flag: SmolStr,
    /// Range of the condition that tests the flag.
    pub test: TextRange,
    /// Range of the line that sets the flag.
    pub set: TextRange,
}

/// Returns the locks of a program in source order.
pub fn locks(body: &Body) -> Vec<Lock> {
    let mut found = Vec::new();
    in_block(body, &body.block, &mut found);
    found
}

fn in_block(body: &Body, block: &[Stmt], found: &mut Vec<Lock>) {
    let mut rest = block;
    while let Some((stmt, after)) = rest.split_first() {
        found.extend(tested(body, stmt).and_then(|(condition, held)| lock(body, condition, held, after.first()?)));
        if let StmtKind::If { arms, .. } = &stmt.kind {
            let taken = arms.iter().filter_map(|(condition, block)| Some(((*condition)?, block.first()?)));
            found.extend(taken.filter_map(|(condition, first)| lock(body, condition, false, first)));
        }
        stmt.blocks().for_each(|inner| in_block(body, inner, found));
        rest = after;
    }
}

/// Returns the condition of a waiting statement, and the condition's value for which the statement continues to wait:
/// `false` for `wait(bBusy==false)`, `true` for `while bBusy==true`.
fn tested(body: &Body, stmt: &Stmt) -> Option<(ExprId, bool)> {
    match &stmt.kind {
        StmtKind::While { condition, .. } => Some(((*condition)?, true)),
        StmtKind::Expr(call) => {
            let Expr::Call(callee, arguments) = body.expr(*call) else { return None };
            let waits = matches!(body.expr(*callee), Expr::Name(name) if name == WAIT);
            Some((*arguments.first().filter(|_| waits)?, false))
        }
        _ => None,
    }
}

/// Returns the lock if `next` sets the flag whose state `condition` tests: `held` is the value of the condition while
/// the flag is set.
fn lock(body: &Body, condition: ExprId, held: bool, next: &Stmt) -> Option<Lock> {
    let StmtKind::Assign { target, value } = &next.kind else { return None };
    let Expr::Name(flag) = body.expr(*target) else { return None };
    let sets = body.constant(*value) == Some(Constant::Bool(true));
    let found = sets && holds_only_if(body, condition, flag, held);
    found.then(|| Lock { flag: flag.clone(), test: body.range(condition), set: next.range })
}

fn names_flag(body: &Body, id: ExprId, flag: &str) -> bool {
    matches!(body.expr(body.without_parentheses(id)), Expr::Name(name) if name == flag)
}

/// Whether the flag is certainly clear once `condition` no longer has the value `value`.
fn holds_only_if(body: &Body, condition: ExprId, flag: &str, value: bool) -> bool {
    match body.expr(body.without_parentheses(condition)) {
        Expr::Name(name) => name == flag && value,
        Expr::Unary(UnaryOp::Not, inner) => holds_only_if(body, *inner, flag, !value),
        Expr::Binary(BinaryOp::And, left, right) if !value => {
            holds_only_if(body, *left, flag, value) || holds_only_if(body, *right, flag, value)
        }
        Expr::Binary(op @ (BinaryOp::Equal | BinaryOp::NotEqual), left, right) if names_flag(body, *left, flag) => {
            body.constant(*right) == Some(Constant::Bool((*op == BinaryOp::Equal) == value))
        }
        _ => false,
    }
}
