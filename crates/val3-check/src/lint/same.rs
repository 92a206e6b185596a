//! Expressions with equal values.

use val3_analysis::body::{Expr, ExprId};

use super::Program;

impl Program<'_> {
    /// Both expressions have the same value if they are evaluated directly after each other: their text is the same and
    /// they call nothing.
    pub(crate) fn is_same(&self, left: ExprId, right: ExprId) -> bool {
        self.may_be_same(left, right) && self.body.is_same(left, right) && !self.has_call(right)
    }

    /// A quick test of the outermost parts alone, so that a long chain of operators is not compared for each of its
    /// operands.
    fn may_be_same(&self, left: ExprId, right: ExprId) -> bool {
        let (left, right) =
            (self.body.expr(self.body.without_parentheses(left)), self.body.expr(self.body.without_parentheses(right)));
        match (left, right) {
            (Expr::Binary(op, ..), Expr::Binary(other, ..)) => op == other,
            _ => std::mem::discriminant(left) == std::mem::discriminant(right),
        }
    }

    fn has_call(&self, id: ExprId) -> bool {
        self.body.within(id).any(|part| matches!(self.body.expr(part), Expr::Call(..)))
    }
}
