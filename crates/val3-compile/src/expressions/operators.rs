//! Binary and unary operators.

use val3_analysis::body::ExprId;
use val3_analysis::ty::Base;
use val3_bytecode::{Callee, InstructionSite, Op, Operand};
use val3_lang::memory::Lanes;
use val3_lang::operators::{self, BinaryOp, UnaryOp};
use val3_lang::types::BaseType;

use crate::emitter::text_register;
use crate::error::{CompileLimit, Result};
use crate::expressions::Expressions;
use crate::location::{CompiledValue, is_number};

impl Expressions<'_, '_> {
    /// Compiles `left op right`.
    pub(crate) fn binary(
        &mut self,
        op: BinaryOp,
        left: ExprId,
        right: ExprId,
        want: Option<Lanes>,
    ) -> Result<CompiledValue> {
        match self.base(left) {
            _ if matches!(op, BinaryOp::And | BinaryOp::Or) => self.logic(op, left, right),
            Base::Builtin(base, _) if is_number(base) || base == BaseType::Dio => self.on_nums(op, left, right, want),
            Base::Builtin(BaseType::String, _) => self.on_texts(op, left, right, want),
            Base::Builtin(base, _) => self.on_structures(op, base, left, right, want),
            Base::User(_) => self.compared(op, left, right, want),
            Base::Unknown => Err(CompileLimit::Unclear),
        }
    }

    /// Compiles `and` or `or`, whose right side is computed only if the left side does not decide (3.1.2). The result
    /// has a separate register, because the right side may read the wanted one.
    fn logic(&mut self, op: BinaryOp, left: ExprId, right: ExprId) -> Result<CompiledValue> {
        let condition = self.out.frame_mut().num()?;
        let end = self.out.code().label();
        self.num_to(left, condition)?;
        self.out.emit(match op {
            BinaryOp::And => Op::JumpUnless { condition, to: end.0 },
            _ => Op::JumpIf { condition, to: end.0 },
        });
        self.num_to(right, condition)?;
        self.out.code().place(end);
        Ok(CompiledValue::num(BaseType::Bool, condition))
    }

    fn on_nums(&mut self, op: BinaryOp, left: ExprId, right: ExprId, want: Option<Lanes>) -> Result<CompiledValue> {
        let (a, b) = self.nums(left, right)?;
        let to = self.out.num_result(want)?;
        self.out.emit(match op {
            BinaryOp::Add => Op::Add { to, a, b },
            BinaryOp::Subtract => Op::Subtract { to, a, b },
            BinaryOp::Multiply => Op::Multiply { to, a, b },
            BinaryOp::Divide => Op::Divide { to, a, b },
            BinaryOp::Remainder => Op::Remainder { to, a, b },
            BinaryOp::Less => Op::Less { to, a, b },
            BinaryOp::LessOrEqual => Op::LessEqual { to, a, b },
            BinaryOp::Greater => Op::Less { to, a: b, b: a },
            BinaryOp::GreaterOrEqual => Op::LessEqual { to, a: b, b: a },
            BinaryOp::Equal => Op::Equal { to, a, b },
            BinaryOp::NotEqual | BinaryOp::Xor => Op::NotEqual { to, a, b },
            BinaryOp::And | BinaryOp::Or => return Err(CompileLimit::Unclear),
        });
        let is_number = operators::binary(op, BaseType::Num, BaseType::Num) == Some(BaseType::Num);
        Ok(CompiledValue::num(if is_number { BaseType::Num } else { BaseType::Bool }, to))
    }

    fn on_texts(&mut self, op: BinaryOp, left: ExprId, right: ExprId, want: Option<Lanes>) -> Result<CompiledValue> {
        let (a, b) = self.texts(left, right)?;
        if op == BinaryOp::Add {
            let register = self.out.text_result(want)?;
            let to = text_register(register)?;
            self.out.emit(Op::Concatenate { to, a, b });
            return Ok(CompiledValue::text(register));
        }
        let to = self.out.num_result(want)?;
        self.out.emit(Op::TextEqual { to, a, b });
        self.negated(op, to)
    }

    /// Returns the truth value in a register, negated for `!=`.
    fn negated(&mut self, op: BinaryOp, to: u16) -> Result<CompiledValue> {
        if op == BinaryOp::NotEqual {
            self.out.emit(Op::Not { to, a: to });
        }
        Ok(CompiledValue::num(BaseType::Bool, to))
    }

    fn on_structures(
        &mut self,
        op: BinaryOp,
        base: BaseType,
        left: ExprId,
        right: ExprId,
        want: Option<Lanes>,
    ) -> Result<CompiledValue> {
        let Some(mut site) = self.binary_site(op, base) else {
            return self.compared(op, left, right, want);
        };
        for id in [left, right] {
            let value = self.value(id, None)?;
            let argument = self.out.argument_of(value)?;
            site.arguments.push(argument);
        }
        let result = operators::binary(op, base, base).ok_or(CompileLimit::Unclear)?;
        self.handled(site, result, want)
    }

    /// Returns the instruction for an operator on structures that has a handler. Other structures are compared field by
    /// field.
    fn binary_site(&self, op: BinaryOp, base: BaseType) -> Option<InstructionSite> {
        let site = InstructionSite::new(Callee::Binary(op, base, self.out.unit().items.arm));
        site.run.is_some().then_some(site)
    }

    /// Compiles `!trA`.
    pub(crate) fn unary_handler(
        &mut self,
        op: UnaryOp,
        operand: ExprId,
        base: BaseType,
        want: Option<Lanes>,
    ) -> Result<CompiledValue> {
        let mut site = InstructionSite::new(Callee::Unary(op, base));
        let value = self.value(operand, None)?;
        let argument = self.out.argument_of(value)?;
        site.arguments.push(argument);
        self.handled(site, base, want)
    }

    fn handled(&mut self, mut site: InstructionSite, result: BaseType, want: Option<Lanes>) -> Result<CompiledValue> {
        let lanes = self.out.result(result, want)?;
        site.result = Some((Operand::Frame(lanes), result));
        self.out.code().instruction(site);
        Ok(CompiledValue::on_frame(result, lanes))
    }

    /// Compiles `==` or `!=`, field by field.
    fn compared(&mut self, op: BinaryOp, left: ExprId, right: ExprId, want: Option<Lanes>) -> Result<CompiledValue> {
        let left = self.value(left, None)?;
        let right = self.value(right, None)?;
        let site = self.out.copy_site(left.base, left.location, right.location)?;
        let to = self.out.num_result(want)?;
        self.out.emit(Op::Compare { to, site });
        self.negated(op, to)
    }

    /// Compiles the comparison with a value that was already computed. Returns the register of the result.
    pub(crate) fn compare_equal(&mut self, left: CompiledValue, right: ExprId) -> Result<u16> {
        let right = self.value_as(right, left.base)?;
        let to = self.out.frame_mut().num()?;
        let base = left.base.builtin();
        if let Some(mut site) = base.and_then(|base| self.binary_site(BinaryOp::Equal, base)) {
            site.arguments = vec![self.out.argument_of(left)?, self.out.argument_of(right)?];
            site.result = Some((Operand::Frame(Lanes::nums(to.into())), BaseType::Bool));
            self.out.code().instruction(site);
        } else {
            let site = self.out.copy_site(left.base, left.location, right.location)?;
            self.out.emit(Op::Compare { to, site });
        }
        Ok(to)
    }
}
