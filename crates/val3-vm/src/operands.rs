//! From operands of the code to places and values in memory.

use val3_bytecode::{
    ArgumentSite, ContainerKind, ContainerRef, Operand, Program, Register, Subscript, TextOperand, TextSource,
};
use val3_lang::call::Argument;
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{self, Lanes, Memory, Place, Slot, StoreId, View};
use val3_lang::values::Text;

use crate::Instance;
use crate::instance::Imported;
use crate::task::Base;

/// The objects that the operands of a program refer to, except the memory.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scope<'i> {
    /// The application or library, with its global data and imports.
    pub(crate) instance: &'i Instance,
    /// The program, with its constants.
    pub(crate) program: &'i Program,
    /// Where its frame begins.
    pub(crate) base: Base,
}

/// A place on the frame.
#[inline(always)]
pub(crate) fn on_frame(base: &Base, lanes: Lanes) -> Place {
    let Base { num, text, link, part, .. } = *base;
    Place::new(StoreId::STACK, Lanes { num, text, link, part } + lanes)
}

/// A place that was looked up, or a parameter by reference.
#[inline(always)]
pub(crate) fn located(memory: &Memory, base: &Base, register: Register) -> Result<Place> {
    let at = base.place as usize + usize::from(register);
    memory.stack.places.get(at).copied().ok_or(Fault::INTERPRETER)
}

impl Scope<'_> {
    /// The container, and the first of its values that can be reached.
    #[inline]
    pub(crate) fn view(&self, memory: &Memory, container: ContainerRef) -> Result<View> {
        self.view_of(memory, container.kind())
    }

    #[inline]
    fn view_of(&self, memory: &Memory, kind: ContainerKind) -> Result<View> {
        let Self { instance, base, .. } = self;
        match kind {
            ContainerKind::Data(number) => {
                instance.data.get(usize::from(number)).copied().map(View::whole).ok_or(Fault::INTERPRETER)
            }
            ContainerKind::Part(number) => {
                let at = base.part as usize + usize::from(number);
                memory.stack.parts.get(at).copied().map(View::whole).ok_or(Fault::INTERPRETER)
            }
            ContainerKind::View(number) => {
                let at = base.view as usize + usize::from(number);
                memory.stack.views.get(at).copied().ok_or(Fault::INTERPRETER)
            }
            ContainerKind::Import(number) => match instance.imports.get(usize::from(number)) {
                Some(Some(Imported::Data(store))) => Ok(View::whole(*store)),
                _ => Err(Fault::LIBRARY_ITEM_MISSING),
            },
            ContainerKind::Builtin(number) => Ok(View::whole(match number {
                0 => Memory::WORLD,
                _ => Memory::FLANGE,
            })),
        }
    }

    /// A container, an array from an index on.
    #[inline(never)]
    pub(crate) fn view_from(&self, memory: &Memory, container: ContainerRef, start: Option<Register>) -> Result<View> {
        let view = self.view(memory, container)?;
        let Some(start) = start else { return Ok(view) };
        let start = memory.store(view.store)?.number1(view, self.num(memory, start)?)?;
        Ok(View { start, ..view })
    }

    /// Where a value is.
    #[inline(always)]
    pub(crate) fn place(&self, memory: &Memory, operand: Operand) -> Result<Place> {
        match operand {
            Operand::Frame(lanes) => Ok(on_frame(&self.base, lanes)),
            Operand::First(container, lanes) => Ok(memory.element(self.view(memory, container)?, 0)?.after(lanes)),
            Operand::Place(register, lanes) => Ok(located(memory, &self.base, register)?.after(lanes)),
        }
    }

    #[inline]
    pub(crate) fn num(&self, memory: &Memory, register: Register) -> Result<f64> {
        let at = self.base.num as usize + usize::from(register);
        memory.stack.nums.get(at).copied().ok_or(Fault::INTERPRETER)
    }

    /// A text.
    #[inline]
    pub(crate) fn text<'m>(&'m self, memory: &'m Memory, operand: TextOperand) -> Result<&'m Text> {
        match operand.source() {
            TextSource::Register(register) => {
                let at = self.base.text as usize + usize::from(register);
                memory.stack.texts.get(at).ok_or(Fault::INTERPRETER)
            }
            TextSource::Constant(number) => self.program.texts.get(usize::from(number)).ok_or(Fault::INTERPRETER),
            TextSource::First(kind) => {
                memory.stores.first_text(self.view_of(memory, kind)?).ok_or(Fault::INDEX_TOO_LARGE)
            }
            TextSource::Place(register) => memory.text(located(memory, &self.base, register)?),
        }
    }

    /// A text to be written.
    #[inline]
    pub(crate) fn text_mut<'m>(&self, memory: &'m mut Memory, operand: TextOperand) -> Result<&'m mut Text> {
        match operand.source() {
            TextSource::Register(register) => {
                let at = self.base.text as usize + usize::from(register);
                memory.stack.texts.get_mut(at).ok_or(Fault::INTERPRETER)
            }
            TextSource::Constant(_) => Err(Fault::INTERPRETER),
            TextSource::First(kind) => {
                let view = self.view_of(memory, kind)?;
                memory.stores.first_text_mut(view).ok_or(Fault::INDEX_TOO_LARGE)
            }
            TextSource::Place(register) => {
                let place = located(memory, &self.base, register)?;
                memory.text_mut(place)
            }
        }
    }

    /// Where a text is that is not a constant.
    fn text_place(&self, memory: &Memory, operand: TextOperand) -> Result<Place> {
        match operand.source() {
            TextSource::Register(register) => {
                let lanes = Lanes { text: u32::from(register), ..Lanes::default() };
                Ok(on_frame(&self.base, lanes))
            }
            TextSource::Constant(_) => Err(Fault::INTERPRETER),
            TextSource::First(kind) => memory.element(self.view_of(memory, kind)?, 0),
            TextSource::Place(register) => located(memory, &self.base, register),
        }
    }

    /// A value of an array.
    #[inline]
    pub(crate) fn element(&self, memory: &Memory, container: ContainerRef, index: Register) -> Result<Place> {
        let view = self.view(memory, container)?;
        let store = memory.store(view.store)?;
        Ok(store.place(view.store, store.number1(view, self.num(memory, index)?)?))
    }

    /// A value of an array of two dimensions.
    pub(crate) fn element2(&self, memory: &Memory, container: ContainerRef, [i, j]: [Register; 2]) -> Result<Place> {
        let view = self.view(memory, container)?;
        let store = memory.store(view.store)?;
        Ok(store.place(view.store, store.number2([self.num(memory, i)?, self.num(memory, j)?])?))
    }

    /// The value of a collection under a key.
    #[inline]
    pub(crate) fn keyed(&self, memory: &Memory, container: ContainerRef, key: TextOperand) -> Result<Place> {
        let view = self.view(memory, container)?;
        let store = memory.store(view.store)?;
        Ok(store.place(view.store, store.number_of(self.text(memory, key)?)?))
    }

    /// An argument of an instruction or program. Inlined, it is built in place: calls of `mid`, `find` and `len` take 0.91
    /// of the time.
    #[inline(always)]
    pub(crate) fn argument(&self, memory: &Memory, site: &ArgumentSite) -> Result<Argument> {
        Ok(match *site {
            ArgumentSite::Value(operand, base) => Argument::Value(self.place(memory, operand)?, base),
            ArgumentSite::UserValue(operand) => Argument::UserValue(self.place(memory, operand)?),
            ArgumentSite::View(container, start) => Argument::View(self.view_from(memory, container, start)?),
            ArgumentSite::Slot(container, at) => Argument::Slot(self.slot(memory, container, at)?),
            ArgumentSite::Library(number) => Argument::Library(number),
        })
    }

    /// A value that need not exist. A library that lacks the container is reported by the instruction.
    fn slot(&self, memory: &Memory, container: ContainerRef, at: Subscript) -> Result<Slot> {
        let view = match self.view(memory, container) {
            Ok(view) => Some(view),
            Err(Fault::LIBRARY_ITEM_MISSING) => None,
            Err(fault) => return Err(fault),
        };
        let num = |register| self.num(memory, register);
        let at = match at {
            Subscript::Whole => memory::Subscript::Whole,
            Subscript::One(i) => memory::Subscript::One(num(i)?),
            Subscript::Two([i, j]) => memory::Subscript::Two([num(i)?, num(j)?]),
            Subscript::Three([i, j, k]) => memory::Subscript::Three([num(i)?, num(j)?, num(k)?]),
            Subscript::Key(key) => memory::Subscript::Key(self.text_place(memory, key)?),
        };
        Ok(Slot { view, at })
    }
}
