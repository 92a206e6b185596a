//! Expressions with equal values.

use val3_analysis::body::{Expr, ExprId};

use super::ProgramView;

impl ProgramView<'_> {
    /// Whether both expressions have the same value if they are evaluated one directly after the other: their text is
    /// the same and they contain no call.
    pub(crate) fn is_same(&self, left: ExprId, right: ExprId) -> bool {
        self.may_be_same(left, right) && self.body.is_same(left, right) && !self.has_call(right)
    }

    /// Whether the outermost parts are the same. This quick test avoids comparing a long chain of operators for each of
    /// its operands.
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
