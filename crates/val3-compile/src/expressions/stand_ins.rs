//! Values and programs that replace add-on instructions (`run.add-ons` in `val3.toml`).

use val3_analysis::add_on_programs::{self, AddOnProgram};
use val3_analysis::body::{Expr, ExprId};
use val3_analysis::ty::Base;
use val3_bytecode::{ArgumentSite, CallSite, ProgramRef};
use val3_config::{AddOnStandIn, StandInValue};
use val3_lang::instruction::ArgumentForm;
use val3_lang::types::BaseType;

use crate::error::{CompileLimit, Result};
use crate::expressions::Expressions;
use crate::expressions::arguments::Formal;
use crate::location::{CompiledValue, ValueLocator};

/// Replacement for an add-on instruction.
pub(crate) enum StandIn {
    Value(StandInValue),
    Program(AddOnProgram),
}

impl Expressions<'_, '_> {
    /// Returns the replacement for the add-on instruction in `call`. A program is ignored if its parameters differ from
    /// the form of the call.
    pub(crate) fn stand_in(&self, call: ExprId) -> Option<StandIn> {
        let Expr::Call(callee, _) = self.body.expr(call) else { return None };
        let Expr::Name(name) = self.body.expr(*callee) else { return None };
        let unit = self.unit();
        match unit.project.config(unit.db)?.run.add_ons.get(name.as_str())? {
            AddOnStandIn::Value(value) => Some(StandIn::Value(value.clone())),
            AddOnStandIn::Program(_) => {
                let program = add_on_programs::program(unit.db, unit.project, name)?;
                let form = &self.types.add_on_call(call)?.form;
                program.fits(unit.db, form).then_some(StandIn::Program(program))
            }
        }
    }

    /// Compiles a call whose value is used.
    pub(crate) fn stand_in_value(
        &mut self,
        call: ExprId,
        stand_in: &StandIn,
        args: &[ExprId],
    ) -> Result<CompiledValue> {
        match stand_in {
            StandIn::Value(value) => self.stand_in_constant(value),
            StandIn::Program(program) => self.call_stand_in(call, program, args)?.ok_or(CompileLimit::Unclear),
        }
    }

    /// Compiles a call that is a statement. A constant value has no effect.
    pub(crate) fn stand_in_stmt(&mut self, call: ExprId, stand_in: &StandIn, args: &[ExprId]) -> Result<()> {
        match stand_in {
            StandIn::Value(_) => Ok(()),
            StandIn::Program(program) => self.call_stand_in(call, program, args).map(drop),
        }
    }

    /// Returns the value as a constant. Values are not converted: their type is the type of the call.
    fn stand_in_constant(&mut self, value: &StandInValue) -> Result<CompiledValue> {
        let mut number = |ty, number| Ok(CompiledValue::num(ty, self.out.frame_mut().constant(number)?));
        match value {
            StandInValue::Bool(value) => number(BaseType::Bool, f64::from(u8::from(*value))),
            StandInValue::Number(value) => number(BaseType::Num, *value),
            StandInValue::Text(text) => {
                let location = ValueLocator::Constant(self.out.code().text(&text.as_str().into())?);
                Ok(CompiledValue { location, base: Base::of(BaseType::String) })
            }
        }
    }

    /// Compiles the program call. If the instruction has a result, the program's last parameter receives it.
    fn call_stand_in(
        &mut self,
        call: ExprId,
        program: &AddOnProgram,
        args: &[ExprId],
    ) -> Result<Option<CompiledValue>> {
        let result = self.types.add_on_call(call).and_then(|call| call.form.result);
        let params = program.params(self.unit().db);
        let formals: Vec<Formal> = params.iter().map(Formal::of).collect();
        let mut boxes = Vec::new();
        let mut arguments = self.arguments(&formals, args, &mut boxes)?;
        let result = match (result, formals.last()) {
            (Some(base), Some(formal)) => {
                let (value, site) = self.result_variable(base, formal.shape)?;
                arguments.push(site);
                Some(value)
            }
            _ => None,
        };
        let program = self.stand_in_program(program)?;
        self.out.code().call(CallSite { program, arguments, passes: None });
        self.unbox(&boxes)?;
        Ok(result)
    }

    fn stand_in_program(&mut self, AddOnProgram { library, name, file }: &AddOnProgram) -> Result<ProgramRef> {
        if library.project == self.unit().project {
            return self.unit().program(name).map(ProgramRef::Own);
        }
        let unit = self.out.unit_mut();
        unit.import_program(&library.alias, name, library.project, *file).map(ProgramRef::Import)
    }

    /// Creates a variable with its type's default value, and the argument that passes the variable by reference.
    fn result_variable(&mut self, base: BaseType, shape: ArgumentForm) -> Result<(CompiledValue, ArgumentSite)> {
        let kind = self.out.builtin_kind(base)?;
        let default = CompiledValue::on_frame(base, self.out.frame_mut().lasting(&kind)?);
        if shape == ArgumentForm::Reference {
            let lanes = self.out.frame_mut().value(kind.size)?;
            let variable = CompiledValue {
                base: Base::of(base).on_arm(self.unit().items.arm),
                ..CompiledValue::on_frame(base, lanes)
            };
            self.out.copy(variable, default)?;
            return Ok((variable, self.out.place_of(variable)?));
        }
        let (container, variable) = self.out.own_container(Base::of(base).on_arm(self.unit().items.arm))?;
        self.out.copy(variable, default)?;
        Ok((variable, ArgumentSite::View(container, None)))
    }
}
