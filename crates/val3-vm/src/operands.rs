//! Resolution of operands to places and values in memory.

use val3_bytecode::{
    ArgumentSite, ContainerKind, ContainerRef, Operand, Program, Register, Storage, Subscript, TextOperand, TextSource,
};
use val3_lang::call::Argument;
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{self, Lanes, Memory, Place, Slot, View};
use val3_lang::values::Text;

use crate::Instance;
use crate::instance::Imported;
use crate::task::Base;

/// Everything to which the operands of a program refer, except the memory.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OperandContext<'i> {
    /// Application or library, with its global data and imports.
    pub(crate) instance: &'i Instance,
    /// Program, with its constants.
    pub(crate) program: &'i Program,
    /// Start of the stack frame.
    pub(crate) base: Base,
}

/// Returns a place on the frame.
#[inline(always)]
pub(crate) fn on_frame(base: &Base, lanes: Lanes) -> Place {
    let Base { num, text, link, part, .. } = *base;
    Place::on_stack(Lanes { num, text, link, part } + lanes)
}

/// Returns a place that was looked up, or the place of a parameter by reference.
#[inline(always)]
pub(crate) fn located(memory: &Memory, base: &Base, register: Register) -> Result<Place> {
    let at = base.place as usize + usize::from(register);
    memory.stack.places.get(at).copied().ok_or(Fault::INTERPRETER)
}

/// Returns the place of a frame variable that is a single value.
pub(crate) fn place_of(memory: &Memory, base: &Base, storage: Storage) -> Option<Place> {
    match storage {
        Storage::Value(lanes) => Some(on_frame(base, lanes)),
        Storage::Place(number) => memory.stack.places.get(base.place as usize + usize::from(number)).copied(),
        Storage::Part(_) | Storage::View(_) => None,
    }
}

/// Returns the view of a frame variable that is a container.
pub(crate) fn view_of(memory: &Memory, base: &Base, storage: Storage) -> Option<View> {
    match storage {
        Storage::Part(number) => {
            memory.stack.parts.get(base.part as usize + usize::from(number)).copied().map(View::whole)
        }
        Storage::View(number) => memory.stack.views.get(base.view as usize + usize::from(number)).copied(),
        Storage::Value(_) | Storage::Place(_) => None,
    }
}

impl OperandContext<'_> {
    /// Returns the container, beginning with the first value that can be reached.
    #[inline]
    pub(crate) fn view(&self, memory: &Memory, container: ContainerRef) -> Result<View> {
        self.view_of(memory, container.kind())
    }

    #[inline]
    pub(crate) fn view_of(&self, memory: &Memory, kind: ContainerKind) -> Result<View> {
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

    /// Returns the container, or an array from an index on.
    #[inline(never)]
    pub(crate) fn view_from(&self, memory: &Memory, container: ContainerRef, start: Option<Register>) -> Result<View> {
        let view = self.view(memory, container)?;
        let Some(start) = start else { return Ok(view) };
        let start = memory.store(view.store)?.number1(view, self.num(memory, start)?)?;
        Ok(View { start, ..view })
    }

    /// Returns the place of a value.
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

    /// Returns a string.
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

    /// Returns a string for writing.
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

    /// Returns the place of a string that is not a constant.
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

    /// Returns the place for an array element.
    #[inline]
    pub(crate) fn element(&self, memory: &Memory, container: ContainerRef, index: Register) -> Result<Place> {
        let view = self.view(memory, container)?;
        let store = memory.store(view.store)?;
        Ok(store.place(view.store, store.number1(view, self.num(memory, index)?)?))
    }

    /// Returns the place for an element in a two-dimensional array.
    pub(crate) fn element2(&self, memory: &Memory, container: ContainerRef, [i, j]: [Register; 2]) -> Result<Place> {
        let view = self.view(memory, container)?;
        let store = memory.store(view.store)?;
        Ok(store.place(view.store, store.number2([self.num(memory, i)?, self.num(memory, j)?])?))
    }

    /// Returns the place of a collection element by its key.
    #[inline]
    pub(crate) fn keyed(&self, memory: &Memory, container: ContainerRef, key: TextOperand) -> Result<Place> {
        let view = self.view(memory, container)?;
        let store = memory.store(view.store)?;
        Ok(store.place(view.store, store.number_of(self.text(memory, key)?)?))
    }

    /// Returns an argument to an instruction or program. Inlining builds it in place: calls of `mid`, `find` and `len`
    /// then need 91 % of the time.
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

    /// Returns a slot for a value that may not exist. If a library does not contain the container, the instruction
    /// reports it.
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
