//! Arguments of instructions and programs (2.6).

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::items::project::SignatureParam;
use val3_analysis::ty::Base;
use val3_bytecode::{ArgumentSite, ContainerKind, ContainerRef, Operand, Register, Subscript, TextSource};
use val3_lang::instruction::ArgumentForm;
use val3_lang::memory::Lanes;
use val3_lang::types::BaseType;
use val3_syntax::TextSlice;

use crate::emitter::text_register;
use crate::error::{CompileLimit, Result};
use crate::expressions::Expressions;
use crate::location::{CompiledValue, is_number};

/// Requirement of a parameter on its argument.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Formal {
    /// Type; `None` for any type.
    pub(crate) base: Option<Base>,
    /// Required form of the argument.
    pub(crate) shape: ArgumentForm,
}

impl Formal {
    /// Returns the requirement of a program's parameter.
    pub(crate) fn of(param: &SignatureParam) -> Self {
        Self { base: Some(param.base), shape: param.shape() }
    }
}

/// A value that is passed as a container without being one (2.3.4): the copy in a container, and the variable to which
/// the copy is assigned after the call.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Boxed {
    copy: CompiledValue,
    variable: CompiledValue,
}

impl Expressions<'_, '_> {
    /// Compiles the arguments of a call, from left to right.
    pub(crate) fn arguments(
        &mut self,
        formals: &[Formal],
        args: &[ExprId],
        boxes: &mut Vec<Boxed>,
    ) -> Result<Vec<ArgumentSite>> {
        let mut sites = Vec::with_capacity(args.len());
        for (at, (formal, id)) in formals.iter().zip(args).enumerate() {
            let site = self.argument(*formal, *id, boxes)?;
            let later = args.part(at + 1..);
            sites.push(self.kept_argument(*formal, site, later)?);
        }
        Ok(sites)
    }

    fn argument(&mut self, formal: Formal, id: ExprId, boxes: &mut Vec<Boxed>) -> Result<ArgumentSite> {
        match formal.shape {
            ArgumentForm::Value => self.by_value(formal.base, id),
            ArgumentForm::Reference if formal.base.is_some() => self.by_reference(id),
            // A variable of any type may be an array (`getData`).
            ArgumentForm::Reference | ArgumentForm::Array { .. } | ArgumentForm::Collection | ArgumentForm::Whole => {
                let (container, start) = self.view(formal.base, id, boxes)?;
                Ok(ArgumentSite::View(container, start))
            }
            ArgumentForm::Slot | ArgumentForm::Item => self.slot(id, boxes),
            ArgumentForm::ProgramCall => Err(CompileLimit::Unclear),
        }
    }

    /// Copies a number passed by value if a later argument may change it.
    fn kept_argument(&mut self, formal: Formal, site: ArgumentSite, later: &[ExprId]) -> Result<ArgumentSite> {
        match site {
            ArgumentSite::Value(Operand::Frame(lanes), base)
                if formal.shape == ArgumentForm::Value
                    && is_number(base)
                    && later.iter().any(|id| self.may_write(*id)) =>
            {
                let register = self.out.kept(crate::location::num_register(lanes))?;
                Ok(ArgumentSite::Value(Operand::Frame(Lanes::nums(register.into())), base))
            }
            other => Ok(other),
        }
    }

    /// Compiles an argument by value: a number in a register, any other value in place.
    fn by_value(&mut self, formal: Option<Base>, id: ExprId) -> Result<ArgumentSite> {
        let value = self.value_as(id, formal.unwrap_or(Base::Unknown))?;
        let read = formal.and_then(Base::builtin) == Some(BaseType::Bool);
        if value.base.builtin() == Some(BaseType::Dio) && read {
            let register = self.out.load(value, None)?;
            return self.out.argument_of(CompiledValue::num(BaseType::Bool, register));
        }
        self.out.argument_of(value)
    }

    fn by_reference(&mut self, id: ExprId) -> Result<ArgumentSite> {
        let variable = self.variable(id)?.ok_or(CompileLimit::Unclear)?;
        self.out.place_of(variable)
    }

    /// Compiles a container, or an array from an index on.
    fn view(
        &mut self,
        formal: Option<Base>,
        id: ExprId,
        boxes: &mut Vec<Boxed>,
    ) -> Result<(ContainerRef, Option<Register>)> {
        if let Expr::Index(of, indexes) = self.body.expr(id)
            && let [index] = **indexes
            && self.base(index).builtin() == Some(BaseType::Num)
        {
            let container = self.container(*of)?.ok_or(CompileLimit::Unclear)?;
            return Ok((container, Some(self.num(index)?)));
        }
        match self.container(id)? {
            Some(container) => Ok((container, None)),
            None => Ok((self.boxed(formal, id, boxes)?, None)),
        }
    }

    fn boxed(&mut self, formal: Option<Base>, id: ExprId, boxes: &mut Vec<Boxed>) -> Result<ContainerRef> {
        let is_variable = !matches!(self.body.expr(id), Expr::Paren(_));
        let variable = if is_variable { self.variable(id)? } else { None };
        let value = match variable {
            Some(variable) => variable,
            None => self.value_as(id, formal.unwrap_or(Base::Unknown))?,
        };
        let (container, copy) = self.out.own_container(value.base)?;
        self.out.copy(copy, value)?;
        boxes.extend(variable.map(|variable| Boxed { copy, variable }));
        Ok(container)
    }

    /// Assigns the boxed values to their variables after a call.
    pub(crate) fn unbox(&mut self, boxes: &[Boxed]) -> Result<()> {
        boxes.iter().try_for_each(|Boxed { copy, variable }| self.out.copy(*variable, *copy))
    }

    /// Compiles an argument for a value that may not exist.
    fn slot(&mut self, id: ExprId, boxes: &mut Vec<Boxed>) -> Result<ArgumentSite> {
        let Expr::Index(of, indexes) = self.body.expr(id) else {
            let container = match self.slot_of(id)? {
                Some(container) => container,
                None => self.boxed(None, id, boxes)?,
            };
            return Ok(ArgumentSite::Slot(container, Subscript::Whole));
        };
        let container = self.slot_of(*of)?.ok_or(CompileLimit::Unclear)?;
        let at = self.subscript(indexes)?;
        Ok(ArgumentSite::Slot(container, self.slot_key(at)?))
    }

    /// Returns the subscript of a slot. A key is passed by place, which a constant does not have.
    pub(crate) fn slot_key(&mut self, at: Subscript) -> Result<Subscript> {
        match at {
            Subscript::Key(key) if matches!(key.source(), TextSource::Constant(_)) => {
                Ok(Subscript::Key(text_register(self.out.kept_text(key)?)?))
            }
            at => Ok(at),
        }
    }

    /// Returns the container of a value that may not exist, even if no interface declares it.
    fn slot_of(&mut self, id: ExprId) -> Result<Option<ContainerRef>> {
        match self.body.expr(id) {
            Expr::Path { library, item } if !self.out.unit().has_item(library, item) => {
                let kind = ContainerKind::Import(self.out.unit_mut().import_missing(library, item)?);
                ContainerRef::new(kind).ok_or(CompileLimit::Containers).map(Some)
            }
            _ => self.container(id),
        }
    }
}
