//! Expressions. The result is computed into the wanted lanes, if it has to be computed.

pub(crate) mod arguments;
mod assignments;
mod instructions;
mod literals;
mod operators;
mod places;
mod stand_ins;
mod steps;

use val3_analysis::body::{Body, Constant, Expr, ExprId};
use val3_analysis::infer::Inference;
use val3_analysis::ty::Base;
use val3_bytecode::{ArgumentSite, Op, Register, TextOperand, TextSource};
use val3_lang::memory::Lanes;
use val3_lang::operators::UnaryOp;
use val3_lang::types::BaseType;

use crate::emitter::{Emitter, text_register};
use crate::error::{CompileLimit, Result};
use crate::location::{CompiledValue, ValueLocator, is_number};
use crate::unit::CompileUnit;

/// Compiles the expressions of a program.
pub(crate) struct Expressions<'u, 'db> {
    /// Output.
    out: Emitter<'u, 'db>,
    body: &'db Body,
    types: &'db Inference,
    /// Whether the present part of a statement neither changes variables before its end nor waits.
    is_pure: bool,
    /// Test of each step of the path that is compiled.
    steps: Option<steps::StepTest>,
}

impl<'u, 'db> Expressions<'u, 'db> {
    /// Creates the compiler for the expressions in this body with these types.
    pub(crate) fn new(out: Emitter<'u, 'db>, body: &'db Body, types: &'db Inference) -> Self {
        Self { out, body, types, is_pure: false, steps: None }
    }

    /// Returns the program's output: frame, code and tables.
    pub(crate) fn out(&mut self) -> &mut Emitter<'u, 'db> {
        &mut self.out
    }

    pub(crate) fn unit(&self) -> &CompileUnit<'db> {
        self.out.unit()
    }

    pub(crate) fn body(&self) -> &'db Body {
        self.body
    }

    /// Begins a part of a statement that consists of these expressions.
    pub(crate) fn begin(&mut self, ids: &[ExprId]) {
        self.is_pure = ids.iter().all(|id| self.is_pure(*id));
    }

    /// Whether the analysis has resolved the instruction or program that an expression calls.
    pub(crate) fn is_known_call(&self, call: ExprId) -> bool {
        self.types.call(call).is_some() || self.types.add_on_call(call).is_some() || self.stand_in(call).is_some()
    }

    /// Returns an expression's type.
    pub(crate) fn base(&self, id: ExprId) -> Base {
        self.types.ty(id).base
    }

    /// Returns an expression's type, which must be built in.
    pub(crate) fn builtin(&self, id: ExprId) -> Result<BaseType> {
        self.base(id).builtin().ok_or(CompileLimit::Unclear)
    }

    /// Compiles an expression. The value of a variable remains at its location; a result may be computed into `want`.
    pub(crate) fn value(&mut self, id: ExprId, want: Option<Lanes>) -> Result<CompiledValue> {
        if let Some((base, number)) = self.constant(id) {
            return Ok(CompiledValue::num(base, self.out.frame_mut().constant(number)?));
        }
        if let Some(variable) = self.variable(id)? {
            return Ok(variable);
        }
        match self.body.expr(id) {
            Expr::Paren(inner) => self.value(*inner, want),
            Expr::String(text) => {
                let location = ValueLocator::Constant(self.out.code().text(text)?);
                Ok(CompiledValue { location, base: Base::of(BaseType::String) })
            }
            Expr::Unary(op, operand) => self.unary(*op, *operand, want),
            Expr::Binary(op, left, right) => self.binary(*op, *left, *right, want),
            Expr::Assign(target, value) => self.assign(*target, *value),
            Expr::Call(callee, args) => self.instruction_value(id, *callee, args, want),
            Expr::Struct(values) => self.literal(self.base(id), values),
            _ => Err(CompileLimit::Unclear),
        }
    }

    /// Compiles an expression to an argument and its type. Variables are passed by place, and containers entirely.
    pub(crate) fn watched(&mut self, id: ExprId) -> Result<(ArgumentSite, Base)> {
        if self.constant(id).is_none() {
            if let Some(container) = self.container(id)? {
                return Ok((ArgumentSite::View(container, None), self.base(id)));
            }
            if let Some(variable) = self.variable(id)? {
                return Ok((self.out.place_of(variable)?, variable.base));
            }
        }
        let value = self.value(id, None)?;
        Ok((self.out.argument_of(value)?, value.base))
    }

    /// Returns the value of a constant expression or enumerator.
    pub(crate) fn constant(&self, id: ExprId) -> Option<(BaseType, f64)> {
        if let Expr::Name(name) = self.body.expr(id) {
            return Some((self.base(id).builtin()?, self.enumerator(name)?));
        }
        match self.body.constant(id)? {
            Constant::Number(number) => Some((BaseType::Num, number)),
            Constant::Bool(value) => Some((BaseType::Bool, f64::from(u8::from(value)))),
            Constant::String(_) => None,
        }
    }

    /// Compiles a number, truth value or enumerator, and returns its register.
    pub(crate) fn num(&mut self, id: ExprId) -> Result<Register> {
        let value = self.value(id, None)?;
        self.out.load(value, None)
    }

    /// Computes a number into a register.
    pub(crate) fn num_to(&mut self, id: ExprId, to: Register) -> Result<()> {
        let want = Some(Lanes::nums(to.into()));
        let value = self.value(id, want)?;
        let from = self.out.load(value, want)?;
        self.out.move_num(to, from);
        Ok(())
    }

    /// Compiles a string.
    pub(crate) fn text(&mut self, id: ExprId) -> Result<TextOperand> {
        let value = self.value(id, None)?;
        self.out.text_operand(value.location)
    }

    /// Compiles two numbers. The left one is read first: a variable that the right side may change is copied.
    pub(crate) fn nums(&mut self, left: ExprId, right: ExprId) -> Result<(Register, Register)> {
        let a = self.num(left)?;
        let a = if self.may_write(right) { self.out.kept(a)? } else { a };
        Ok((a, self.num(right)?))
    }

    /// Compiles two strings like [`nums`](Self::nums).
    pub(crate) fn texts(&mut self, left: ExprId, right: ExprId) -> Result<(TextOperand, TextOperand)> {
        let a = self.text(left)?;
        let is_constant = matches!(a.source(), TextSource::Constant(_));
        let kept = !is_constant && self.may_write(right) || !self.is_stable(a);
        let a = if kept { text_register(self.out.kept_text(a)?)? } else { a };
        Ok((a, self.text(right)?))
    }

    /// Whether the rest of the statement cannot change this string. Registers for strings are as stable as for numbers.
    pub(crate) fn is_stable(&self, text: TextOperand) -> bool {
        self.is_pure || matches!(text.source(), TextSource::Register(_) | TextSource::Constant(_))
    }

    /// Whether the expression has no effect and depends on no input: it calls no instruction and assigns nothing.
    pub(crate) fn is_pure(&self, id: ExprId) -> bool {
        self.body.within(id).all(|id| {
            let is_port = matches!(self.base(id).builtin(), Some(BaseType::Dio | BaseType::Sio));
            !is_port && !matches!(self.body.expr(id), Expr::Call(..) | Expr::Assign(..))
        })
    }

    /// Whether the expression may change variables: it calls an instruction that has parameters by reference.
    pub(crate) fn may_write(&self, id: ExprId) -> bool {
        self.body.within(id).any(|id| match self.body.expr(id) {
            Expr::Call(..) => match self.types.call(id).and_then(|call| call.form) {
                Some(form) => form.params.iter().any(|param| param.shape.is_by_reference()),
                None => true,
            },
            _ => false,
        })
    }

    fn unary(&mut self, op: UnaryOp, operand: ExprId, want: Option<Lanes>) -> Result<CompiledValue> {
        let base = self.builtin(operand)?;
        match op {
            UnaryOp::Negate => {
                let a = self.num(operand)?;
                let to = self.out.num_result(want)?;
                self.out.emit(Op::Negate { to, a });
                Ok(CompiledValue::num(BaseType::Num, to))
            }
            UnaryOp::Not if is_number(base) || base == BaseType::Dio => {
                let a = self.num(operand)?;
                let to = self.out.num_result(want)?;
                self.out.emit(Op::Not { to, a });
                Ok(CompiledValue::num(BaseType::Bool, to))
            }
            UnaryOp::Not => self.unary_handler(op, operand, base, want),
        }
    }
}
