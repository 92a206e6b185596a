//! Operations on texts, structures and places.

use val3_bytecode::{CopySite, Op, Program, Register, Whole};
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{Place, View};
use val3_lang::values::Text;

use crate::Frame;
use crate::arguments::{located, place};
use crate::arithmetic::{concatenate, truth};
use crate::turn_context::TurnContext;

impl TurnContext<'_> {
    /// Executes an operation that does more than compute numbers.
    #[inline(never)]
    pub(crate) fn on_values(&mut self, op: Op, frame: &Frame, program: &Program) -> Result<()> {
        match op {
            Op::TextConstant { to, constant } => {
                let text = program.texts.get(usize::from(constant)).ok_or(Fault::INTERPRETER)?;
                self.set_text(frame, to, *text)
            }
            Op::TextMove { to, from } => self.set_text(frame, to, *self.text(frame, from)?),
            Op::Concatenate { to, a, b } => {
                let first = frame.base.text as usize;
                let texts = self.space.memory.stack.texts.get_mut(first..).ok_or(Fault::INTERPRETER)?;
                concatenate(texts, to, (a, b))
            }
            Op::TextEqual { to, a, b } => self.set(frame, to, truth(self.text(frame, a)? == self.text(frame, b)?)),

            Op::LoadFirst { to, whole, lane } => {
                let place = self.space.memory.element(self.view(frame, whole)?, 0)?;
                self.set(frame, to, self.space.memory.num(place, u32::from(lane))?)
            }
            Op::StoreFirst { whole, lane, from } => {
                let place = self.space.memory.element(self.view(frame, whole)?, 0)?;
                self.space.memory.set_num(place, u32::from(lane), self.get(frame, from)?)
            }
            Op::LoadElement { to, whole, index } => {
                let place = self.element(frame, whole, index)?;
                self.set(frame, to, self.space.memory.num(place, 0)?)
            }
            Op::StoreElement { whole, index, from } => {
                let place = self.element(frame, whole, index)?;
                self.space.memory.set_num(place, 0, self.get(frame, from)?)
            }
            Op::LoadElement2 { to, whole, i, j } => {
                let place = self.element2(frame, whole, [i, j])?;
                self.set(frame, to, self.space.memory.num(place, 0)?)
            }
            Op::StoreElement2 { whole, i, j, from } => {
                let place = self.element2(frame, whole, [i, j])?;
                self.space.memory.set_num(place, 0, self.get(frame, from)?)
            }

            Op::LocateFirst { to, whole } => {
                let place = self.space.memory.element(self.view(frame, whole)?, 0)?;
                self.set_place(frame, to, place)
            }
            Op::Locate { to, whole, index } => self.set_place(frame, to, self.element(frame, whole, index)?),
            Op::Locate2 { to, whole, i, j } => self.set_place(frame, to, self.element2(frame, whole, [i, j])?),
            Op::Locate3 { to, whole, i } => {
                let at = [self.get(frame, i)?, self.get(frame, i + 1)?, self.get(frame, i + 2)?];
                let view = self.view(frame, whole)?;
                let store = self.space.memory.store(view.store)?;
                self.set_place(frame, to, store.place(view.store, store.number3(at)?))
            }
            Op::LocateKey { to, whole, key } => {
                let (view, key) = (self.view(frame, whole)?, self.text(frame, key)?);
                let store = self.space.memory.store(view.store)?;
                self.set_place(frame, to, store.place(view.store, store.number_of(key)?))
            }
            Op::Field { to, place, field } => {
                let place = located(&self.space.memory, &frame.base, place)?;
                let view = View::whole(self.space.memory.part(place, u32::from(field))?);
                let at = frame.base.view as usize + usize::from(to);
                *self.space.memory.stack.views.get_mut(at).ok_or(Fault::INTERPRETER)? = view;
                Ok(())
            }
            Op::LoadText { to, place } => {
                let text = *self.space.memory.text(located(&self.space.memory, &frame.base, place)?)?;
                self.set_text(frame, to, text)
            }
            Op::StoreText { place, from } => {
                let place = located(&self.space.memory, &frame.base, place)?;
                self.space.memory.set_text(place, *self.text(frame, from)?)
            }

            Op::Copy { site } => {
                let site = program.copies.get(site as usize).ok_or(Fault::INTERPRETER)?;
                let (from, to) = self.both(frame, site)?;
                self.space.memory.copy(&site.kind, from, to)
            }
            Op::Compare { to, site } => {
                let site = program.copies.get(site as usize).ok_or(Fault::INTERPRETER)?;
                let (a, b) = self.both(frame, site)?;
                self.set(frame, to, truth(self.space.memory.equal(&site.kind, a, b)?))
            }
            _ => Err(Fault::INTERPRETER),
        }
    }

    /// A number at a place.
    #[inline]
    pub(crate) fn load_num(&self, frame: &Frame, place: Register, lane: u16) -> Result<f64> {
        let place = located(&self.space.memory, &frame.base, place)?;
        self.space.memory.num(place, u32::from(lane))
    }

    /// Writes what [`load_num`](Self::load_num) reads.
    #[inline]
    pub(crate) fn store_num(&mut self, frame: &Frame, (place, lane): (Register, u16), value: f64) -> Result<()> {
        let place = located(&self.space.memory, &frame.base, place)?;
        self.space.memory.set_num(place, u32::from(lane), value)
    }

    fn view(&self, frame: &Frame, whole: Whole) -> Result<View> {
        self.scope(frame)?.view(whole)
    }

    /// A value of an array.
    fn element(&self, frame: &Frame, whole: Whole, index: Register) -> Result<Place> {
        let view = self.view(frame, whole)?;
        let store = self.space.memory.store(view.store)?;
        Ok(store.place(view.store, store.number1(view, self.get(frame, index)?)?))
    }

    /// A value of an array of two dimensions.
    fn element2(&self, frame: &Frame, whole: Whole, [i, j]: [Register; 2]) -> Result<Place> {
        let view = self.view(frame, whole)?;
        let store = self.space.memory.store(view.store)?;
        Ok(store.place(view.store, store.number2([self.get(frame, i)?, self.get(frame, j)?])?))
    }

    fn get(&self, frame: &Frame, register: Register) -> Result<f64> {
        let at = frame.base.num as usize + usize::from(register);
        self.space.memory.stack.nums.get(at).copied().ok_or(Fault::INTERPRETER)
    }

    fn set(&mut self, frame: &Frame, register: Register, value: f64) -> Result<()> {
        let at = frame.base.num as usize + usize::from(register);
        *self.space.memory.stack.nums.get_mut(at).ok_or(Fault::INTERPRETER)? = value;
        Ok(())
    }

    fn text(&self, frame: &Frame, register: Register) -> Result<&Text> {
        let at = frame.base.text as usize + usize::from(register);
        self.space.memory.stack.texts.get(at).ok_or(Fault::INTERPRETER)
    }

    fn set_text(&mut self, frame: &Frame, register: Register, text: Text) -> Result<()> {
        let at = frame.base.text as usize + usize::from(register);
        *self.space.memory.stack.texts.get_mut(at).ok_or(Fault::INTERPRETER)? = text;
        Ok(())
    }

    fn set_place(&mut self, frame: &Frame, register: Register, place: Place) -> Result<()> {
        let at = frame.base.place as usize + usize::from(register);
        *self.space.memory.stack.places.get_mut(at).ok_or(Fault::INTERPRETER)? = place;
        Ok(())
    }

    /// The two values of a copy or comparison.
    fn both(&self, frame: &Frame, site: &CopySite) -> Result<(Place, Place)> {
        let memory = &self.space.memory;
        Ok((place(memory, &frame.base, site.from)?, place(memory, &frame.base, site.to)?))
    }
}
