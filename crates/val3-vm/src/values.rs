//! Operations on strings, structures and places.

use val3_bytecode::{CopySite, Op, Register, TextOperand};
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{Place, StoreId, View};

use crate::arithmetic::truth;
use crate::operands::OperandContext;
use crate::turn_context::TurnContext;

impl TurnContext<'_> {
    /// Executes an operation on other values than numbers in registers.
    #[inline(never)]
    pub(crate) fn on_values(&mut self, op: Op, scope: OperandContext<'_>) -> Result<()> {
        let memory = &self.space.memory;
        match op {
            Op::LoadFirst { to, container, lane } => {
                let place = memory.element(scope.view(memory, container)?, 0)?;
                self.set(&scope, to, memory.num(place, u32::from(lane))?)
            }
            Op::StoreFirst { container, lane, from } => {
                let place = memory.element(scope.view(memory, container)?, 0)?;
                let value = scope.num(memory, from)?;
                self.space.memory.set_num(place, u32::from(lane), value)
            }
            Op::LoadElement { to, container, index } => {
                let place = scope.element(memory, container, index)?;
                self.set(&scope, to, memory.num(place, 0)?)
            }
            Op::StoreElement { container, index, from } => {
                let place = scope.element(memory, container, index)?;
                let value = scope.num(memory, from)?;
                self.space.memory.set_num(place, 0, value)
            }
            Op::LoadElement2 { to, container, i, j } => {
                let place = scope.element2(memory, container, [i, j])?;
                self.set(&scope, to, memory.num(place, 0)?)
            }
            Op::StoreElement2 { container, i, j, from } => {
                let place = scope.element2(memory, container, [i, j])?;
                let value = scope.num(memory, from)?;
                self.space.memory.set_num(place, 0, value)
            }

            Op::LocateFirst { to, container } => {
                self.set_place(&scope, to, memory.element(scope.view(memory, container)?, 0)?)
            }
            Op::Locate { to, container, index } => self.set_place(&scope, to, scope.element(memory, container, index)?),
            Op::Locate2 { to, container, i, j } => {
                self.set_place(&scope, to, scope.element2(memory, container, [i, j])?)
            }
            Op::Locate3 { to, container, i } => {
                let at = [scope.num(memory, i)?, scope.num(memory, i + 1)?, scope.num(memory, i + 2)?];
                let view = scope.view(memory, container)?;
                let store = memory.store(view.store)?;
                self.set_place(&scope, to, store.place(view.store, store.number3(at)?))
            }
            Op::FirstField { to, container, field } => {
                let place = memory.element(scope.view(memory, container)?, 0)?;
                self.set_view(&scope, to, memory.part(place, u32::from(field))?)
            }
            Op::ElementField { to, container, index, field } => {
                let place = scope.element(memory, container, index)?;
                self.set_view(&scope, to, memory.part(place, u32::from(field))?)
            }

            Op::Copy { site } => {
                let site = scope.program.copies.get(site as usize).ok_or(Fault::INTERPRETER)?;
                let (from, to) = self.both(&scope, site)?;
                self.space.memory.copy(&site.kind, from, to)
            }
            Op::Compare { to, site } => {
                let site = scope.program.copies.get(site as usize).ok_or(Fault::INTERPRETER)?;
                let (a, b) = self.both(&scope, site)?;
                self.set(&scope, to, truth(memory.equal(&site.kind, a, b)?))
            }
            _ => Err(Fault::INTERPRETER),
        }
    }

    /// Executes `to = from`.
    #[inline(never)]
    pub(crate) fn move_text(&mut self, scope: &OperandContext<'_>, to: TextOperand, from: TextOperand) -> Result<()> {
        let memory = &mut self.space.memory;
        let text = *scope.text(memory, from)?;
        *scope.text_mut(memory, to)? = text;
        Ok(())
    }

    /// Executes `to = a + b`, in place if `to` is `a`.
    #[inline(never)]
    pub(crate) fn concatenate(
        &mut self,
        scope: &OperandContext<'_>,
        to: TextOperand,
        [a, b]: [TextOperand; 2],
    ) -> Result<()> {
        let memory = &mut self.space.memory;
        let right = *scope.text(memory, b)?;
        if to == a {
            *scope.text_mut(memory, to)? += &right;
        } else {
            let sum = *scope.text(memory, a)? + &right;
            *scope.text_mut(memory, to)? = sum;
        }
        Ok(())
    }

    /// Whether `a == b`.
    #[inline]
    pub(crate) fn texts_equal(&self, scope: &OperandContext<'_>, a: TextOperand, b: TextOperand) -> Result<bool> {
        let memory = &self.space.memory;
        Ok(scope.text(memory, a)? == scope.text(memory, b)?)
    }

    fn set(&mut self, scope: &OperandContext<'_>, register: Register, value: f64) -> Result<()> {
        let at = scope.base.num as usize + usize::from(register);
        *self.space.memory.stack.nums.get_mut(at).ok_or(Fault::INTERPRETER)? = value;
        Ok(())
    }

    fn set_place(&mut self, scope: &OperandContext<'_>, register: Register, place: Place) -> Result<()> {
        let at = scope.base.place as usize + usize::from(register);
        *self.space.memory.stack.places.get_mut(at).ok_or(Fault::INTERPRETER)? = place;
        Ok(())
    }

    fn set_view(&mut self, scope: &OperandContext<'_>, register: Register, store: StoreId) -> Result<()> {
        let at = scope.base.view as usize + usize::from(register);
        *self.space.memory.stack.views.get_mut(at).ok_or(Fault::INTERPRETER)? = View::whole(store);
        Ok(())
    }

    /// Returns the two values of a copy or comparison.
    fn both(&self, scope: &OperandContext<'_>, site: &CopySite) -> Result<(Place, Place)> {
        let memory = &self.space.memory;
        Ok((scope.place(memory, site.from)?, scope.place(memory, site.to)?))
    }
}
