//! Flags that a program tests on one line and sets on the next, as if that were a lock.
//!
//! Tasks take turns between lines (5.4), so two of them may both find the flag free. `setMutex` tests and sets within
//! one line (5.9).

use smol_str::SmolStr;
use val3_lang::instructions::WAIT;
use val3_lang::operators::{BinaryOp, UnaryOp};
use val3_syntax::TextRange;

use crate::body::{Body, Constant, Expr, ExprId, Stmt, StmtKind};

/// One such flag.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Lock {
    /// The variable.
    pub flag: SmolStr,
    /// Where it is tested.
    pub test: TextRange,
    /// The line that sets it.
    pub set: TextRange,
}

/// Every such flag of a program, by the position of the test.
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

/// The condition of a statement that waits, and the value of that condition for which it keeps waiting:
/// `wait(bBusy==false)` waits while it is false, `while bBusy==true` while it is true.
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

/// `next` sets the flag for which `condition` asks whether it is `held`.
fn lock(body: &Body, condition: ExprId, held: bool, next: &Stmt) -> Option<Lock> {
    let StmtKind::Assign { target, value } = &next.kind else { return None };
    let Expr::Name(flag) = body.expr(*target) else { return None };
    let sets = body.constant(*value) == Some(Constant::Bool(true));
    let found = sets && holds_only_if(body, condition, flag, held);
    found.then(|| Lock { flag: flag.clone(), test: body.range(condition), set: next.range })
}

/// `condition` holds only if the flag is `value`.
fn holds_only_if(body: &Body, condition: ExprId, flag: &str, value: bool) -> bool {
    let is_flag = |id: ExprId| matches!(body.expr(body.without_parentheses(id)), Expr::Name(name) if name == flag);
    match body.expr(body.without_parentheses(condition)) {
        Expr::Name(name) => name == flag && value,
        Expr::Unary(UnaryOp::Not, inner) => holds_only_if(body, *inner, flag, !value),
        Expr::Binary(BinaryOp::And, left, right) if !value => {
            holds_only_if(body, *left, flag, value) || holds_only_if(body, *right, flag, value)
        }
        Expr::Binary(op @ (BinaryOp::Equal | BinaryOp::NotEqual), left, right) if is_flag(*left) => {
            body.constant(*right) == Some(Constant::Bool((*op == BinaryOp::Equal) == value))
        }
        _ => false,
    }
}
