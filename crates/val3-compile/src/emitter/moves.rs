//! Reading and writing of values.

use val3_analysis::ty::Base;
use val3_bytecode::{
    ArgumentSite, Callee, ContainerKind, ContainerRef, CopySite, InstructionSite, Op, Operand, Register, Subscript,
    TextOperand, TextSource,
};
use val3_lang::memory::Lanes;
use val3_lang::types::BaseType;

use crate::emitter::Emitter;
use crate::error::{CompileLimit, Result};
use crate::frame::narrow;
use crate::location::num_register;
use crate::location::{CompiledValue, ValueLocator, is_number};

impl Emitter<'_, '_> {
    /// Loads a number, truth value or enumerator into a register. For an input, its state is read.
    pub(crate) fn load(&mut self, value: CompiledValue, want: Option<Lanes>) -> Result<Register> {
        if value.base.builtin() == Some(BaseType::Dio) {
            return self.read_digital(value, want);
        }
        if let ValueLocator::Frame(lanes) = value.location {
            return Ok(num_register(lanes));
        }
        let to = self.num_result(want)?;
        match value.location {
            ValueLocator::First(container, lanes) => {
                let lane = narrow(lanes.num);
                self.emit(Op::LoadFirst { to, container, lane });
            }
            ValueLocator::Element { container, at: Subscript::One(index), plain: true } => {
                self.emit(Op::LoadElement { to, container, index });
            }
            ValueLocator::Element { container, at: Subscript::Two([i, j]), plain: true } => {
                self.emit(Op::LoadElement2 { to, container, i, j });
            }
            ValueLocator::Element { container, at: Subscript::Key(key), plain: true } => {
                self.emit(Op::LoadKey { to, container, key });
            }
            location => {
                let (place, lanes) = self.located(location)?;
                self.emit(Op::Load { to, place, lane: narrow(lanes.num) });
            }
        }
        Ok(to)
    }

    fn read_digital(&mut self, value: CompiledValue, want: Option<Lanes>) -> Result<Register> {
        let to = self.num_result(want)?;
        let argument = self.argument_of(value)?;
        let mut site = InstructionSite::new(Callee::Assignment(BaseType::Bool, BaseType::Dio));
        site.arguments.push(argument);
        site.result = Some((Operand::Frame(Lanes::nums(to.into())), BaseType::Bool));
        self.code.instruction(site);
        Ok(to)
    }

    /// Stores a number, truth value or enumerator.
    pub(crate) fn store(&mut self, to: ValueLocator, from: Register) -> Result<()> {
        match to {
            ValueLocator::Frame(lanes) => self.move_num(num_register(lanes), from),
            ValueLocator::First(container, lanes) => {
                self.emit(Op::StoreFirst { container, lane: narrow(lanes.num), from })
            }
            ValueLocator::Element { container, at: Subscript::One(index), plain: true } => {
                self.emit(Op::StoreElement { container, index, from });
            }
            ValueLocator::Element { container, at: Subscript::Two([i, j]), plain: true } => {
                self.emit(Op::StoreElement2 { container, i, j, from });
            }
            ValueLocator::Element { container, at: Subscript::Key(key), plain: true } => {
                self.emit(Op::StoreKey { container, key, from });
            }
            location => {
                let (place, lanes) = self.located(location)?;
                self.emit(Op::Store { place, lane: narrow(lanes.num), from });
            }
        }
        Ok(())
    }

    /// Moves a number to a register.
    pub(crate) fn move_num(&mut self, to: Register, from: Register) {
        if to != from {
            self.emit(Op::Move { to, from });
        }
    }

    /// Returns a string as an operand: its location if no lookup is necessary.
    pub(crate) fn text_operand(&mut self, location: ValueLocator) -> Result<TextOperand> {
        let source = match location {
            ValueLocator::Frame(lanes) => TextSource::Register(narrow(lanes.text)),
            ValueLocator::Constant(number) => TextSource::Constant(number),
            ValueLocator::First(container, _) if is_there(container) => TextSource::First(container.kind()),
            location => TextSource::Place(self.located(location)?.0),
        };
        TextOperand::new(source).ok_or(CompileLimit::Registers)
    }

    /// Copies a string to a separate register, which other code does not change.
    pub(crate) fn kept_text(&mut self, from: TextOperand) -> Result<Register> {
        let register = self.frame.text()?;
        let to = text_register(register)?;
        self.emit(Op::TextMove { to, from });
        Ok(register)
    }

    /// Returns a value's location, for operations that use it in place.
    pub(crate) fn operand(&mut self, location: ValueLocator) -> Result<Operand> {
        match location {
            ValueLocator::Frame(lanes) => Ok(Operand::Frame(lanes)),
            ValueLocator::First(container, lanes) if is_there(container) => Ok(Operand::First(container, lanes)),
            ValueLocator::Constant(_) => {
                let constant = self.text_operand(location)?;
                let register = self.kept_text(constant)?;
                Ok(Operand::Frame(Lanes { text: register.into(), ..Lanes::default() }))
            }
            location => {
                let (place, lanes) = self.located(location)?;
                Ok(Operand::Place(place, lanes))
            }
        }
    }

    /// Assigns a value of the same type to a variable.
    pub(crate) fn copy(&mut self, to: CompiledValue, from: CompiledValue) -> Result<()> {
        match to.base.builtin() {
            Some(base) if is_number(base) => {
                let want = to.location.lanes();
                let register = self.load(from, want)?;
                self.store(to.location, register)
            }
            Some(BaseType::String) => {
                let from = self.text_operand(from.location)?;
                let to = self.text_operand(to.location)?;
                if to != from {
                    self.emit(Op::TextMove { to, from });
                }
                Ok(())
            }
            _ if to.location == from.location => Ok(()),
            _ => {
                let site = self.copy_site(to.base, from.location, to.location)?;
                self.emit(Op::Copy { site });
                Ok(())
            }
        }
    }

    /// Adds a copy or comparison to the table.
    pub(crate) fn copy_site(&mut self, base: Base, from: ValueLocator, to: ValueLocator) -> Result<u32> {
        let kind = self.kind(base)?;
        let (from, to) = (self.operand(from)?, self.operand(to)?);
        Ok(self.code.copy_site(CopySite { kind, from, to }))
    }

    /// Creates a container of the frame with one value, and returns both.
    pub(crate) fn own_container(&mut self, base: Base) -> Result<(ContainerRef, CompiledValue)> {
        let kind = self.kind(base)?;
        let number = self.frame.part(kind, val3_lang::memory::ContainerShape::ELEMENT)?;
        let container = ContainerRef::new(ContainerKind::Part(number)).ok_or(CompileLimit::Containers)?;
        Ok((container, CompiledValue { location: ValueLocator::First(container, Lanes::default()), base }))
    }

    /// Copies a number that later code may change.
    pub(crate) fn kept(&mut self, register: Register) -> Result<Register> {
        let to = self.frame.num()?;
        self.move_num(to, register);
        Ok(to)
    }

    /// Returns an argument for a value.
    pub(crate) fn argument_of(&mut self, value: CompiledValue) -> Result<ArgumentSite> {
        match value.base.builtin() {
            Some(base) if is_number(base) => {
                let register = self.load(value, None)?;
                Ok(ArgumentSite::Value(Operand::Frame(Lanes::nums(register.into())), base))
            }
            _ => self.place_of(value),
        }
    }

    /// Returns an argument for a variable's place.
    pub(crate) fn place_of(&mut self, value: CompiledValue) -> Result<ArgumentSite> {
        let operand = self.operand(value.location)?;
        match value.base {
            Base::Builtin(base, _) => Ok(ArgumentSite::Value(operand, base)),
            Base::User(_) => Ok(ArgumentSite::UserValue(operand)),
            Base::Unknown => Err(CompileLimit::Unclear),
        }
    }

    /// Looks up a value immediately, so that it can be used several times.
    pub(crate) fn settled(&mut self, value: CompiledValue) -> Result<CompiledValue> {
        let base = value.base.builtin();
        let location = match value.location {
            _ if base.is_some_and(|base| is_number(base) || base == BaseType::Dio) => {
                let register = self.load(value, None)?;
                return Ok(CompiledValue::num(BaseType::Num, register));
            }
            location @ (ValueLocator::Frame(_) | ValueLocator::Place(..) | ValueLocator::Constant(_)) => location,
            location => {
                let (place, lanes) = self.located(location)?;
                ValueLocator::Place(place, lanes)
            }
        };
        Ok(CompiledValue { location, base: value.base })
    }
}

/// Whether the container is known to exist while the program runs. A library's data may be missing, which is detected
/// where the program uses them.
fn is_there(container: ContainerRef) -> bool {
    matches!(container.kind(), ContainerKind::Data(_) | ContainerKind::Part(_) | ContainerKind::View(_))
}

/// Returns a string register as an operand.
pub(crate) fn text_register(register: Register) -> Result<TextOperand> {
    TextOperand::new(TextSource::Register(register)).ok_or(CompileLimit::Registers)
}
