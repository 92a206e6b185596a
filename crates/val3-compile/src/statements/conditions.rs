//! Conditions as jumps: a comparison and its jump are one operation, and `and` and `or` compute no truth value.

use val3_analysis::body::{Constant, Expr, ExprId};
use val3_bytecode::Op;
use val3_lang::operators::{BinaryOp, UnaryOp};
use val3_lang::types::BaseType;

use crate::code::Label;
use crate::error::Result;
use crate::location::is_number;
use crate::statements::Statements;

impl Statements<'_, '_> {
    /// Compiles a jump to `label` if the expression equals `when`; otherwise execution continues with the next
    /// operation.
    pub(crate) fn branch(&mut self, id: ExprId, when: bool, label: Label) -> Result<()> {
        match self.values.body().expr(id) {
            Expr::Paren(inner) => self.branch(*inner, when, label),
            Expr::Unary(UnaryOp::Not, operand) => self.branch(*operand, !when, label),
            Expr::Binary(op @ (BinaryOp::And | BinaryOp::Or), left, right) => {
                self.branch_logic(*op, *left, *right, when, label)
            }
            Expr::Binary(op @ (BinaryOp::Equal | BinaryOp::NotEqual), left, right) => {
                self.branch_equality(id, *op, *left, *right, when, label)
            }
            Expr::Binary(op, left, right) if self.values.base(*left).builtin() == Some(BaseType::Num) => {
                self.branch_order(*op, *left, *right, when, label)
            }
            _ => self.branch_value(id, when, label),
        }
    }

    fn branch_value(&mut self, id: ExprId, when: bool, label: Label) -> Result<()> {
        match self.values.body().constant(id) {
            Some(Constant::Bool(value)) if value == when => self.out().emit(Op::Jump { to: label.0 }),
            Some(Constant::Bool(_)) => {}
            _ => {
                let condition = self.values.num(id)?;
                self.out().emit(jump(condition, when, label));
            }
        }
        Ok(())
    }

    /// Compiles `and` or `or`: if one side decides, it jumps to the label, or past the other side.
    fn branch_logic(&mut self, op: BinaryOp, left: ExprId, right: ExprId, when: bool, label: Label) -> Result<()> {
        let decides = op == BinaryOp::Or;
        if when == decides {
            self.branch(left, when, label)?;
            return self.branch(right, when, label);
        }
        let past = self.out().code().label();
        self.branch(left, decides, past)?;
        self.branch(right, when, label)?;
        self.out().code().place(past);
        Ok(())
    }

    /// Compiles an equality. `x == true` is `x`. The comparison of numbers and the jump are one operation; NaN equals
    /// no number.
    fn branch_equality(
        &mut self,
        id: ExprId,
        op: BinaryOp,
        left: ExprId,
        right: ExprId,
        when: bool,
        label: Label,
    ) -> Result<()> {
        let when_equal = (op == BinaryOp::Equal) == when;
        if let Some(Constant::Bool(value)) = self.values.body().constant(right) {
            return self.branch(left, value == when_equal, label);
        }
        let base = self.values.base(left).builtin();
        if base == Some(BaseType::String) && self.values.body().constant(id).is_none() {
            let ((a, b), to) = (self.values.texts(left, right)?, label.0);
            self.out().emit(if when_equal { Op::IfTextEqual { a, b, to } } else { Op::UnlessTextEqual { a, b, to } });
            return Ok(());
        }
        if !base.is_some_and(|base| is_number(base) || base == BaseType::Dio) {
            return self.branch_value(id, when, label);
        }
        let ((a, b), to) = (self.values.nums(left, right)?, label.0);
        self.out().emit(if when_equal { Op::IfEqual { a, b, to } } else { Op::UnlessEqual { a, b, to } });
        Ok(())
    }

    /// Compiles a comparison and its jump as one operation. Comparisons with NaN are false, so the negation of `a < b`
    /// is not `b <= a`.
    fn branch_order(&mut self, op: BinaryOp, left: ExprId, right: ExprId, when: bool, label: Label) -> Result<()> {
        let ((left, right), to) = (self.values.nums(left, right)?, label.0);
        let swapped = matches!(op, BinaryOp::Greater | BinaryOp::GreaterOrEqual);
        let (a, b) = if swapped { (right, left) } else { (left, right) };
        self.out().emit(match (op, when) {
            (BinaryOp::Less | BinaryOp::Greater, true) => Op::IfLess { a, b, to },
            (BinaryOp::Less | BinaryOp::Greater, false) => Op::UnlessLess { a, b, to },
            (_, true) => Op::IfLessEqual { a, b, to },
            (_, false) => Op::UnlessLessEqual { a, b, to },
        });
        Ok(())
    }
}

fn jump(condition: u16, when: bool, label: Label) -> Op {
    let to = label.0;
    if when { Op::JumpIf { condition, to } } else { Op::JumpUnless { condition, to } }
}
