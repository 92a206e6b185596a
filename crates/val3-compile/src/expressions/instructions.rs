//! Instruction calls.

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::ty::Base;
use val3_bytecode::{ArgumentSite, Callee, InstructionSite, Op, Operand, Register};
use val3_lang::instruction::{ArgumentForm, Instruction, InstructionParam, Overload};
use val3_lang::instructions;
use val3_lang::memory::Lanes;
use val3_lang::number_functions::NumberFunction;
use val3_lang::types::BaseType;
use val3_lang::versions::Version;

use crate::error::{CompileLimit, Result};
use crate::expressions::Expressions;
use crate::expressions::arguments::Formal;
use crate::expressions::steps::StepTest;
use crate::location::num_register;
use crate::location::{CompiledValue, is_number};

/// A call whose form is resolved.
struct ChosenForm {
    site: InstructionSite,
    formals: Vec<Formal>,
    result: Option<BaseType>,
    /// Function that the call computes, if it has no other effect.
    function: Option<NumberFunction>,
}

impl ChosenForm {
    fn of(
        instruction: &'static Instruction,
        form: &'static Overload,
        result: Option<BaseType>,
        version: Version,
    ) -> Self {
        let formal = |param: &InstructionParam| Formal { base: param.ty.map(Base::of), shape: param.shape };
        Self {
            site: InstructionSite::new(Callee::Form(instruction, form)),
            formals: form.params.iter().map(formal).collect(),
            result,
            function: NumberFunction::of(instruction, form, version),
        }
    }

    /// Whether an argument is a value that may not exist.
    fn has_item(&self) -> bool {
        self.formals.iter().any(|formal| formal.shape == ArgumentForm::Item)
    }

    /// Returns the operation that replaces the call, if it is a function of numbers.
    fn operation(&self) -> Option<Op> {
        let (function, to) = (self.function?, register(&self.site.result.as_ref()?.0)?);
        let a = self.number_argument(0)?;
        let or_first = |at: usize| if at < self.formals.len() { self.number_argument(at) } else { Some(a) };
        Some(Op::Function { function, to, a, b: or_first(1)?, c: or_first(2)? })
    }

    /// Returns the register of a number argument; `None` for any other argument.
    fn number_argument(&self, at: usize) -> Option<Register> {
        match self.site.arguments.get(at)? {
            ArgumentSite::Value(operand, base) if is_number(*base) => register(operand),
            _ => None,
        }
    }
}

impl Expressions<'_, '_> {
    /// Compiles a call whose value is used.
    pub(crate) fn instruction_value(
        &mut self,
        id: ExprId,
        callee: ExprId,
        args: &[ExprId],
        want: Option<Lanes>,
    ) -> Result<CompiledValue> {
        if let Some(stand_in) = self.stand_in(id) {
            return self.stand_in_value(id, &stand_in, args);
        }
        if self.waits(id) == Some(instructions::WATCH) {
            return self.watch(args, want);
        }
        let mut called = self.called(id)?;
        let base = called.result.ok_or(CompileLimit::Unclear)?;
        let has_steps = called.has_item() && args.iter().any(|id| self.has_steps(*id));
        // A step may read the variable that receives the result.
        let lanes = self.out.result(base, want.filter(|_| !has_steps))?;
        called.site.result = Some((Operand::Frame(lanes), base));
        if has_steps {
            let (site, condition) = (called.site.clone(), num_register(lanes));
            let end = self.out.code().label();
            let test = StepTest { site, condition, end };
            self.with_steps(Some(test), |values| values.execute(called, callee, args))?;
            self.out.code().place(end);
        } else {
            self.execute(called, callee, args)?;
        }
        Ok(CompiledValue {
            location: crate::location::ValueLocator::Frame(lanes),
            base: Base::of(base).on_arm(self.out.unit().items.arm),
        })
    }

    /// Compiles a call that is a statement.
    pub(crate) fn instruction_stmt(&mut self, id: ExprId) -> Result<()> {
        let Expr::Call(callee, args) = self.body.expr(id) else { return Err(CompileLimit::Unclear) };
        if let Some(stand_in) = self.stand_in(id) {
            return self.stand_in_stmt(id, &stand_in, args);
        }
        match self.waits(id) {
            Some(instructions::WAIT) => self.wait(args),
            Some(_) => self.watch(args, None).map(drop),
            None => {
                let called = self.called(id)?;
                self.execute(called, *callee, args)
            }
        }
    }

    fn execute(&mut self, mut called: ChosenForm, callee: ExprId, args: &[ExprId]) -> Result<()> {
        if let Expr::Path { library, .. } = self.body.expr(callee) {
            called.site.arguments.push(ArgumentSite::Library(self.out.unit().library(library)?));
        }
        let mut boxes = Vec::new();
        let arguments = self.arguments(&called.formals, args, &mut boxes)?;
        called.site.arguments.extend(arguments);
        match called.operation() {
            Some(operation) => self.out.emit(operation),
            None => self.out.code().instruction(called.site),
        }
        self.unbox(&boxes)
    }

    fn called(&self, id: ExprId) -> Result<ChosenForm> {
        let version = self.out.unit().items.version;
        if let Some(call) = self.types.call(id) {
            let form = call.form.or_else(|| only_form(call.instruction)).ok_or(CompileLimit::Unclear)?;
            return Ok(ChosenForm::of(call.instruction, form, form.result, version));
        }
        let call = self.types.add_on_call(id).ok_or(CompileLimit::Unclear)?;
        // An instruction that the catalogue contains too behaves as there, and the catalogue's form determines how
        // arguments are passed.
        if let Some((instruction, form)) = call.form.known(&call.name) {
            return Ok(ChosenForm::of(instruction, form, call.form.result, version));
        }
        let params = call.form.params.iter();
        let formals = params.map(|param| Formal { base: param.ty.map(Base::of), shape: param.shape }).collect();
        let site = InstructionSite::new(Callee::Lacking(call.name.to_string()));
        Ok(ChosenForm { site, formals, result: call.form.result, function: None })
    }

    /// Returns the name of the instruction if it waits for a condition.
    fn waits(&self, id: ExprId) -> Option<&'static str> {
        let name = self.types.call(id)?.instruction.name;
        matches!(name, instructions::WAIT | instructions::WATCH).then_some(name)
    }

    /// Compiles `wait(condition)`: the condition is computed again in each turn (5.10).
    fn wait(&mut self, args: &[ExprId]) -> Result<()> {
        let &[condition] = args else { return Err(CompileLimit::Unclear) };
        let retry = self.out.code().here();
        let condition = self.num(condition)?;
        self.out.emit(Op::WaitUntil { condition, retry: retry.0 });
        Ok(())
    }

    /// Compiles `watch(condition, seconds)`: the time is computed once, the condition in each turn (5.10).
    fn watch(&mut self, args: &[ExprId], want: Option<Lanes>) -> Result<CompiledValue> {
        let &[condition, seconds] = args else { return Err(CompileLimit::Unclear) };
        let seconds = self.num(seconds)?;
        let seconds = self.out.kept(seconds)?;
        let retry = self.out.code().here();
        let condition = self.num(condition)?;
        let to = self.out.num_result(want)?;
        self.out.emit(Op::Watch { to, condition, seconds, retry: retry.0 });
        Ok(CompiledValue::num(BaseType::Bool, to))
    }
}

/// Returns the instruction's form if there is only one, which applies even if an argument is missing.
fn only_form(instruction: &'static Instruction) -> Option<&'static Overload> {
    match instruction.overloads {
        [form] => Some(form),
        _ => None,
    }
}

/// Returns the register of a number on the frame.
fn register(operand: &Operand) -> Option<Register> {
    if let Operand::Frame(lanes) = operand { Some(num_register(*lanes)) } else { None }
}
