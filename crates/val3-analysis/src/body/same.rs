//! Whether two expressions of a body say the same.

use super::{Body, Expr, ExprId};

impl Body {
    /// Both expressions are written alike, parentheses and ways to write a constant aside. Whether they yield the
    /// same value depends on what happens between them.
    pub fn is_same(&self, left: ExprId, right: ExprId) -> bool {
        match (self.constant(left), self.constant(right)) {
            (Some(left), Some(right)) => return left == right,
            (None, None) => {}
            _ => return false,
        }
        match (self.expr(self.peel(left)), self.expr(self.peel(right))) {
            (Expr::Name(left), Expr::Name(right)) => left == right,
            (
                Expr::Path { library: left_library, item: left_item },
                Expr::Path { library: right_library, item: right_item },
            ) => left_library == right_library && left_item == right_item,
            (Expr::Unary(left_op, left), Expr::Unary(right_op, right)) => {
                left_op == right_op && self.is_same(*left, *right)
            }
            (Expr::Binary(left_op, a, b), Expr::Binary(right_op, c, d)) => {
                left_op == right_op && self.are_same(&[*a, *b], &[*c, *d])
            }
            (Expr::Index(left, left_keys), Expr::Index(right, right_keys)) => {
                self.is_same(*left, *right) && self.are_same(left_keys, right_keys)
            }
            (
                Expr::Field { base: left, field: left_field, .. },
                Expr::Field { base: right, field: right_field, .. },
            ) => left_field == right_field && self.is_same(*left, *right),
            (Expr::Call(left, left_args), Expr::Call(right, right_args)) => {
                self.is_same(*left, *right) && self.are_same(left_args, right_args)
            }
            _ => false,
        }
    }

    fn are_same(&self, left: &[ExprId], right: &[ExprId]) -> bool {
        left.len() == right.len() && left.iter().zip(right).all(|(left, right)| self.is_same(*left, *right))
    }
}
