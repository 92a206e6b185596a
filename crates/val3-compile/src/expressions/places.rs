//! Names, indexes and fields: the variable, or part of a variable, that an expression names (2.5.2, 2.5.3).

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::ty::Base;
use val3_bytecode::{ContainerKind, ContainerRef, Register, Storage, Subscript};
use val3_lang::memory::{Lanes, enumerator, field_offset};
use val3_lang::types::BaseType;
use val3_lang::{builtins, enumerations};

use crate::emitter::text_register;
use crate::error::{CompileLimit, Result};
use crate::expressions::Expressions;
use crate::location::{CompiledValue, ValueLocator};

impl Expressions<'_, '_> {
    /// Returns the variable that an expression names; `None` for a computed value.
    pub(crate) fn variable(&mut self, id: ExprId) -> Result<Option<CompiledValue>> {
        let base = self.base(id);
        let location = match self.body.expr(id) {
            Expr::Paren(inner) => return self.variable(*inner),
            Expr::Name(name) => match self.out.frame().find(name) {
                Some(Storage::Value(lanes)) => Some(ValueLocator::Frame(lanes)),
                Some(Storage::Place(place)) => Some(ValueLocator::Place(place, Lanes::default())),
                Some(_) | None => self.container(id)?.map(first),
            },
            Expr::Path { .. } => self.container(id)?.map(first),
            Expr::Index(of, indexes) => Some(self.element(*of, indexes, base)?),
            Expr::Field { base: of, field, .. } => match self.base(*of) {
                Base::User(_) => self.container(id)?.map(first),
                _ => Some(self.field(*of, field)?),
            },
            _ => None,
        };
        Ok(location.map(|location| CompiledValue { location, base }))
    }

    /// Returns the container that an expression names without an index; `None` if the variable is not a container.
    pub(crate) fn container(&mut self, id: ExprId) -> Result<Option<ContainerRef>> {
        let kind = match self.body.expr(id) {
            Expr::Name(name) => match self.out.frame().find(name) {
                Some(Storage::Part(number)) => Some(ContainerKind::Part(number)),
                Some(Storage::View(number)) => Some(ContainerKind::View(number)),
                Some(Storage::Value(_) | Storage::Place(_)) => None,
                None => self.global(name),
            },
            Expr::Path { library, item } => {
                Some(ContainerKind::Import(self.out.unit_mut().import_data(library, item)?))
            }
            Expr::Field { base, field, .. } => match self.base(*base) {
                Base::User(_) => Some(ContainerKind::View(self.user_field(*base, field)?)),
                _ => None,
            },
            _ => None,
        };
        kind.map(|kind| ContainerRef::new(kind).ok_or(CompileLimit::Containers)).transpose()
    }

    /// Returns global data, or a built-in variable.
    fn global(&self, name: &str) -> Option<ContainerKind> {
        let builtin = || builtins::BUILTINS.iter().position(|builtin| builtin.is_variable && builtin.name == name);
        let number = |at| u16::try_from(at).ok();
        self.out
            .unit()
            .data(name)
            .map(ContainerKind::Data)
            .or_else(|| builtin().and_then(number).map(ContainerKind::Builtin))
    }

    /// Compiles `of[indexes]`.
    fn element(&mut self, of: ExprId, indexes: &[ExprId], base: Base) -> Result<ValueLocator> {
        let Some(container) = self.container(of)? else { return self.only_element(of, indexes) };
        let plain = matches!(base.builtin(), Some(BaseType::Num | BaseType::Bool));
        Ok(ValueLocator::Element { container, at: self.subscript(indexes)?, plain })
    }

    /// Compiles `of[0]` for a variable that is a single value. A fragment may use a local as an array although its
    /// program does not.
    fn only_element(&mut self, of: ExprId, indexes: &[ExprId]) -> Result<ValueLocator> {
        let is_first =
            self.out.frame().is_fragment && indexes.iter().all(|index| self.body.number(*index) == Some(0.0));
        let variable = if is_first { self.variable(of)? } else { None };
        variable.map(|variable| variable.location).ok_or(CompileLimit::Unclear)
    }

    /// Compiles the indexes or the key between brackets. A key is read when the element is looked up, or earlier if the
    /// statement may change it.
    pub(crate) fn subscript(&mut self, indexes: &[ExprId]) -> Result<Subscript> {
        // An index is no step of the path.
        self.with_steps(None, |values| values.indexes(indexes))
    }

    fn indexes(&mut self, indexes: &[ExprId]) -> Result<Subscript> {
        Ok(match *indexes {
            [key] if self.base(key).builtin() == Some(BaseType::String) => {
                let key = self.text(key)?;
                Subscript::Key(if self.is_stable(key) { key } else { text_register(self.out.kept_text(key)?)? })
            }
            [index] => Subscript::One(self.num(index)?),
            [i, j] => Subscript::Two([self.num(i)?, self.num(j)?]),
            [_, _, _] => {
                let first = self.run(indexes)?;
                Subscript::Three([first, first + 1, first + 2])
            }
            _ => return Err(CompileLimit::Unclear),
        })
    }

    /// Compiles numbers into consecutive registers, and returns the first register.
    pub(crate) fn run(&mut self, ids: &[ExprId]) -> Result<Register> {
        let first = self.out.frame_mut().nums(u32::try_from(ids.len()).map_err(|_| CompileLimit::Registers)?)?;
        for (to, id) in (first..).zip(ids) {
            self.num_to(*id, to)?;
        }
        Ok(first)
    }

    /// Compiles a field of a built-in type: lanes within the value.
    fn field(&mut self, of: ExprId, field: &str) -> Result<ValueLocator> {
        let value = self.value(of, None)?;
        self.test_step(value.location)?;
        let Base::Builtin(base, arm) = value.base else { return Err(CompileLimit::Unclear) };
        let offset = field_offset(base, arm.or(self.out.unit().items.arm), field).ok_or(CompileLimit::Unclear)?;
        self.out.after(value.location, offset)
    }

    /// Looks up the container for a field of a user type in a view.
    fn user_field(&mut self, of: ExprId, field: &str) -> Result<Register> {
        let value = self.variable(of)?.ok_or(CompileLimit::Unclear)?;
        self.test_step(value.location)?;
        let kind = self.out.kind(value.base)?;
        let number = kind.fields.iter().position(|known| known.name == field).ok_or(CompileLimit::Unclear)?;
        let field = u16::try_from(number).map_err(|_| CompileLimit::Items)?;
        self.out.field_view(value.location, field)
    }

    /// Returns an enumerator's number, unless a variable hides the name.
    pub(crate) fn enumerator(&self, name: &str) -> Option<f64> {
        let hidden = self.out.frame().find(name).is_some() || self.global(name).is_some();
        enumerations::find(name).filter(|_| !hidden).map(|found| enumerator(found.name))
    }
}

fn first(container: ContainerRef) -> ValueLocator {
    ValueLocator::First(container, Lanes::default())
}
