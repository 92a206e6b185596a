//! Constant expressions: their values are computed from literals.

use smol_str::SmolStr;
use val3_lang::operators::{BinaryOp, UnaryOp};

use super::{Body, Expr, ExprId};

/// A value that is known before the program runs.
#[derive(Debug, Clone, PartialEq)]
pub enum Constant {
    /// A number.
    Number(f64),
    /// A string.
    String(SmolStr),
    /// A truth value.
    Bool(bool),
}

impl Body {
    /// Returns the value of `id` if the expression consists only of literals.
    pub fn constant(&self, id: ExprId) -> Option<Constant> {
        match self.expr(id) {
            Expr::Number(value) => Some(Constant::Number(*value)),
            Expr::String(text) => Some(Constant::String(text.clone())),
            Expr::Bool(value) => Some(Constant::Bool(*value)),
            Expr::Paren(inner) => self.constant(*inner),
            Expr::Unary(op, operand) => unary(*op, self.constant(*operand)?),
            Expr::Binary(op, left, right) => binary(*op, self.constant(*left)?, self.constant(*right)?),
            _ => None,
        }
    }

    /// Returns the number value of `id` if the expression is constant.
    pub fn number(&self, id: ExprId) -> Option<f64> {
        match self.constant(id)? {
            Constant::Number(value) => Some(value),
            _ => None,
        }
    }

    /// Returns the string value of `id` if the expression is constant.
    pub fn string(&self, id: ExprId) -> Option<SmolStr> {
        match self.constant(id)? {
            Constant::String(text) => Some(text),
            _ => None,
        }
    }

    /// Returns the constant prefix of the string `id`, for example `part` for `"part"+sName`.
    pub fn beginning(&self, id: ExprId) -> SmolStr {
        if let Some(whole) = self.string(id) {
            return whole;
        }
        match self.expr(id) {
            Expr::Paren(inner) => self.beginning(*inner),
            Expr::Binary(BinaryOp::Add, left, right) => match self.string(*left) {
                Some(first) => [first.as_str(), self.beginning(*right).as_str()].concat().into(),
                None => self.beginning(*left),
            },
            _ => SmolStr::default(),
        }
    }
}

/// Applies a unary operator.
pub(crate) fn unary(op: UnaryOp, operand: Constant) -> Option<Constant> {
    match (op, operand) {
        (UnaryOp::Negate, Constant::Number(value)) => Some(Constant::Number(-value)),
        (UnaryOp::Not, Constant::Bool(value)) => Some(Constant::Bool(!value)),
        _ => None,
    }
}

/// Applies a binary operator.
pub(crate) fn binary(op: BinaryOp, left: Constant, right: Constant) -> Option<Constant> {
    match (left, right) {
        (Constant::Number(left), Constant::Number(right)) => numbers(op, left, right),
        (Constant::String(left), Constant::String(right)) => strings(op, &left, &right),
        (Constant::Bool(left), Constant::Bool(right)) => truths(op, left, right).map(Constant::Bool),
        _ => None,
    }
}

fn numbers(op: BinaryOp, left: f64, right: f64) -> Option<Constant> {
    let number = match op {
        BinaryOp::Add => left + right,
        BinaryOp::Subtract => left - right,
        BinaryOp::Multiply => left * right,
        BinaryOp::Divide if right != 0.0 => left / right,
        BinaryOp::Remainder if right != 0.0 => left % right,
        _ => return compared(op, left.partial_cmp(&right)?).map(Constant::Bool),
    };
    Some(Constant::Number(number))
}

fn strings(op: BinaryOp, left: &SmolStr, right: &SmolStr) -> Option<Constant> {
    match op {
        BinaryOp::Add => Some(Constant::String([left.as_str(), right.as_str()].concat().into())),
        BinaryOp::Equal => Some(Constant::Bool(left == right)),
        BinaryOp::NotEqual => Some(Constant::Bool(left != right)),
        _ => None,
    }
}

fn compared(op: BinaryOp, order: std::cmp::Ordering) -> Option<bool> {
    Some(match op {
        BinaryOp::Equal => order.is_eq(),
        BinaryOp::NotEqual => order.is_ne(),
        BinaryOp::Less => order.is_lt(),
        BinaryOp::LessOrEqual => order.is_le(),
        BinaryOp::Greater => order.is_gt(),
        BinaryOp::GreaterOrEqual => order.is_ge(),
        _ => return None,
    })
}

fn truths(op: BinaryOp, left: bool, right: bool) -> Option<bool> {
    Some(match op {
        BinaryOp::And => left && right,
        BinaryOp::Or => left || right,
        BinaryOp::Xor | BinaryOp::NotEqual => left != right,
        BinaryOp::Equal => left == right,
        _ => return None,
    })
}
