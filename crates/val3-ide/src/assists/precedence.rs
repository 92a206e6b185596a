//! Parentheses required by operator precedence.

use val3_analysis::body::{Body, Expr, ExprId};
use val3_lang::operators::{BinaryOp, UnaryOp};

/// Whether the expression `new` needs parentheses as the operand `id` of `parent`.
pub(super) fn needs_parentheses(body: &Body, parent: Option<ExprId>, id: ExprId, new: ExprId) -> bool {
    match parent.map(|parent| body.expr(parent)) {
        Some(Expr::Binary(op, left, _)) if *left == id => binding(body, new) < op.precedence(),
        // Operators of equal precedence group from the left, and a sign after an operator is hard to read.
        Some(Expr::Binary(op, ..)) => binding(body, new) <= op.precedence() || is_sum(*op) && has_sign(body, new),
        Some(Expr::Unary(..)) => binding(body, new) <= UnaryOp::PRECEDENCE,
        Some(Expr::Field { .. } | Expr::Index(..)) if is_base(body, parent, id) => binding(body, new) < u8::MAX,
        _ => false,
    }
}

/// Whether the expression needs parentheses as the right operand of `op`.
pub(super) fn needs_parentheses_after(body: &Body, op: BinaryOp, id: ExprId) -> bool {
    binding(body, id) <= op.precedence()
}

/// Precedence of the outermost operator; the maximum without an operator.
fn binding(body: &Body, id: ExprId) -> u8 {
    match body.expr(id) {
        Expr::Binary(op, ..) => op.precedence(),
        Expr::Unary(..) => UnaryOp::PRECEDENCE,
        Expr::Assign(..) => 0,
        _ => u8::MAX,
    }
}

fn is_sum(op: BinaryOp) -> bool {
    op.precedence() >= BinaryOp::Subtract.precedence()
}

/// Whether the expression starts with a minus sign.
fn has_sign(body: &Body, id: ExprId) -> bool {
    match body.expr(id) {
        Expr::Unary(UnaryOp::Negate, _) => true,
        Expr::Binary(_, left, _) => has_sign(body, *left),
        _ => false,
    }
}

/// Whether `id` is the base of a field access or an index.
fn is_base(body: &Body, parent: Option<ExprId>, id: ExprId) -> bool {
    match parent.map(|parent| body.expr(parent)) {
        Some(Expr::Field { base, .. } | Expr::Index(base, _)) => *base == id,
        _ => false,
    }
}
