//! Assignments, which also return the written value (2.4, 3.5.2, 3.7.2).

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::ty::Base;
use val3_bytecode::{Callee, InstructionSite, Operand};
use val3_lang::types::BaseType;

use crate::error::{CompileLimit, Result};
use crate::expressions::Expressions;
use crate::location::{CompiledValue, ValueLocator, is_number};

impl Expressions<'_, '_> {
    /// Compiles `target = value`, and returns the written value.
    ///
    /// The order is: index or key of the variable, value, lookup of the variable.
    pub(crate) fn assign(&mut self, target: ExprId, value: ExprId) -> Result<CompiledValue> {
        let to = self.variable(target)?.ok_or(CompileLimit::Unclear)?;
        if let Expr::Struct(values) = self.body.expr(self.body.without_parentheses(value)) {
            self.literal_to(to, values)?;
            return Ok(to);
        }
        let from = self.value(value, wanted(to))?;
        match (to.base.builtin(), from.base.builtin()) {
            (Some(BaseType::Dio), _) => self.write_digital(to, from),
            (Some(BaseType::Sio), Some(base)) => self.write_serial(to, from, base),
            (Some(base), Some(BaseType::Sio)) => self.read_serial(to, from, base),
            (Some(base), _) if is_number(base) => {
                let register = self.out.load(from, wanted(to))?;
                self.out.store(to.location, register)?;
                Ok(CompiledValue::num(base, register))
            }
            _ => {
                self.out.copy(to, from)?;
                Ok(from)
            }
        }
    }

    /// Compiles `dioOut = condition`, which sets an output.
    fn write_digital(&mut self, to: CompiledValue, from: CompiledValue) -> Result<CompiledValue> {
        let register = self.out.load(from, None)?;
        let state = CompiledValue::num(BaseType::Bool, register);
        let mut site = InstructionSite::new(Callee::Assignment(BaseType::Dio, BaseType::Bool));
        site.arguments = vec![self.out.argument_of(to)?, self.out.argument_of(state)?];
        self.out.code().instruction(site);
        Ok(state)
    }

    /// Compiles `sioOut = text` or `sioOut = number`, which sends. The result is the sent value.
    fn write_serial(&mut self, to: CompiledValue, from: CompiledValue, base: BaseType) -> Result<CompiledValue> {
        let sent = self.out.result(base, None)?;
        let mut site = InstructionSite::new(Callee::Assignment(BaseType::Sio, base));
        site.arguments = vec![self.out.argument_of(to)?, self.out.argument_of(from)?];
        site.result = Some((Operand::Frame(sent), base));
        self.out.code().instruction(site);
        Ok(CompiledValue::on_frame(base, sent))
    }

    /// Compiles `text = sioIn` or `number = sioIn`, which receives.
    fn read_serial(&mut self, to: CompiledValue, from: CompiledValue, base: BaseType) -> Result<CompiledValue> {
        let received = self.out.result(base, wanted(to))?;
        let mut site = InstructionSite::new(Callee::Assignment(base, BaseType::Sio));
        site.arguments = vec![self.out.argument_of(from)?];
        site.result = Some((Operand::Frame(received), base));
        self.out.code().instruction(site);
        let value = CompiledValue::on_frame(base, received);
        self.out.copy(to, value)?;
        Ok(value)
    }

    /// Compiles an expression where a value of type `base` is expected, which `{…}` requires.
    pub(crate) fn value_as(&mut self, id: ExprId, base: Base) -> Result<CompiledValue> {
        match self.body.expr(self.body.without_parentheses(id)) {
            Expr::Struct(values) => self.literal(base, values),
            _ => self.value(id, None),
        }
    }
}

/// Returns the lanes into which a result may be computed directly. Only variables on the frame allow it, because other
/// variables are written completely or remain unchanged.
fn wanted(to: CompiledValue) -> Option<val3_lang::memory::Lanes> {
    match to.location {
        ValueLocator::Frame(lanes) => Some(lanes),
        _ => None,
    }
}
