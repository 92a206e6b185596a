//! From operands of the code to places in memory.

use val3_bytecode::{ArgumentSite, Operand, Register, SlotSite, Whole, WholeKind};
use val3_lang::call::Argument;
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{Lanes, Memory, Place, Slot, SlotAt, StoreId, View};

use crate::Instance;
use crate::instance::Imported;
use crate::task::Base;

/// The frame in which operands mean something.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scope<'m> {
    pub(crate) memory: &'m Memory,
    pub(crate) instance: &'m Instance,
    pub(crate) base: Base,
}

/// What a program gets for a parameter.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Given {
    /// A value, to be copied or referred to.
    Value(Place),
    /// A container.
    Container(View),
}

/// Where a value is.
#[inline]
pub(crate) fn place(memory: &Memory, base: &Base, operand: Operand) -> Result<Place> {
    match operand {
        Operand::Frame(lanes) => Ok(on_frame(base, lanes)),
        Operand::Place(register, lanes) => Ok(located(memory, base, register)?.behind(lanes)),
    }
}

/// A place on the frame.
pub(crate) fn on_frame(base: &Base, lanes: Lanes) -> Place {
    let Base { num, text, link, part, .. } = *base;
    Place::new(StoreId::STACK, Lanes { num, text, link, part } + lanes)
}

/// A place that was looked up, or a parameter by reference.
#[inline]
pub(crate) fn located(memory: &Memory, base: &Base, register: Register) -> Result<Place> {
    let at = base.place as usize + usize::from(register);
    memory.stack.places.get(at).copied().ok_or(Fault::INTERPRETER)
}

impl Scope<'_> {
    /// The container, and the first of its values that can be reached.
    #[inline]
    pub(crate) fn view(&self, whole: Whole) -> Result<View> {
        let Self { memory, instance, base } = self;
        match whole.kind() {
            WholeKind::Data(number) => {
                instance.data.get(usize::from(number)).copied().map(View::whole).ok_or(Fault::INTERPRETER)
            }
            WholeKind::Part(number) => {
                let at = base.part as usize + usize::from(number);
                memory.stack.parts.get(at).copied().map(View::whole).ok_or(Fault::INTERPRETER)
            }
            WholeKind::View(number) => {
                let at = base.view as usize + usize::from(number);
                memory.stack.views.get(at).copied().ok_or(Fault::INTERPRETER)
            }
            WholeKind::Import(number) => match instance.imports.get(usize::from(number)) {
                Some(Some(Imported::Data(store))) => Ok(View::whole(*store)),
                _ => Err(Fault::LIBRARY_ITEM_MISSING),
            },
            WholeKind::Builtin(number) => Ok(View::whole(match number {
                0 => Memory::WORLD,
                _ => Memory::FLANGE,
            })),
        }
    }

    pub(crate) fn num(&self, register: Register) -> Result<f64> {
        let at = self.base.num as usize + usize::from(register);
        self.memory.stack.nums.get(at).copied().ok_or(Fault::INTERPRETER)
    }

    /// The argument of an instruction.
    #[inline]
    pub(crate) fn argument(&self, site: &ArgumentSite) -> Result<Argument> {
        Ok(match *site {
            ArgumentSite::Value(operand, base) => Argument::Value(place(self.memory, &self.base, operand)?, base),
            ArgumentSite::UserValue(operand) => Argument::UserValue(place(self.memory, &self.base, operand)?),
            ArgumentSite::View(whole, start) => Argument::View(self.part_of(whole, start)?),
            ArgumentSite::Slot(whole, at) => Argument::Slot(self.slot(whole, at)?),
            ArgumentSite::Library(number) => Argument::Library(number),
        })
    }

    /// The argument of a program.
    #[inline]
    pub(crate) fn given(&self, site: &ArgumentSite) -> Result<Given> {
        match *site {
            ArgumentSite::Value(operand, _) | ArgumentSite::UserValue(operand) => {
                place(self.memory, &self.base, operand).map(Given::Value)
            }
            ArgumentSite::View(whole, start) => self.part_of(whole, start).map(Given::Container),
            ArgumentSite::Slot(..) | ArgumentSite::Library(_) => Err(Fault::INTERPRETER),
        }
    }

    /// A container, an array from an index on.
    fn part_of(&self, whole: Whole, start: Option<Register>) -> Result<View> {
        let view = self.view(whole)?;
        let Some(start) = start else { return Ok(view) };
        let start = self.memory.store(view.store)?.number1(view, self.num(start)?)?;
        Ok(View { start, ..view })
    }

    /// A slot of a library's data that is not there is no fault: the instruction tells.
    fn slot(&self, whole: Whole, at: SlotSite) -> Result<Slot> {
        let view = match self.view(whole) {
            Ok(view) => Some(view),
            Err(Fault::LIBRARY_ITEM_MISSING) => None,
            Err(fault) => return Err(fault),
        };
        let at = match at {
            SlotSite::Whole => SlotAt::Whole,
            SlotSite::Index(first, count) => {
                let mut indexes = [0.0; 3];
                for (index, register) in indexes.iter_mut().zip(first..).take(usize::from(count)) {
                    *index = self.num(register)?;
                }
                SlotAt::Index(indexes, count)
            }
            SlotSite::Key(register) => {
                let lane = Lanes { text: u32::from(register), ..Lanes::default() };
                SlotAt::Key(*self.memory.text(on_frame(&self.base, lane))?)
            }
        };
        Ok(Slot { view, at })
    }
}
