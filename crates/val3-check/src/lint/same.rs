//! Expressions that say the same.

use val3_analysis::body::{Expr, ExprId};

use super::Program;

impl Program<'_> {
    /// Both expressions have the same value whenever they are asked one after the other: the same variables, constants
    /// and operators, and no call.
    pub(crate) fn is_same(&self, a: ExprId, b: ExprId) -> bool {
        let (a, b) = (self.body.peel(a), self.body.peel(b));
        let (first, second) = (self.body.expr(a), self.body.expr(b));
        let alike = match (first, second) {
            (Expr::Binary(op, ..), Expr::Binary(other, ..)) => op == other,
            (Expr::Unary(op, _), Expr::Unary(other, _)) => op == other,
            (Expr::Field { field, .. }, Expr::Field { field: other, .. }) => field == other,
            (Expr::Index(..), Expr::Index(..)) => true,
            (Expr::Name(_) | Expr::Path { .. } | Expr::Number(_) | Expr::String(_) | Expr::Bool(_), _) => {
                first == second
            }
            _ => false,
        };
        let (parts, others) = (first.parts(), second.parts());
        alike
            && parts.len() == others.len()
            && parts.iter().zip(&others).all(|(part, other)| self.is_same(*part, *other))
    }
}
