//! Lookup of values and their fields (2.5.2, 2.5.3).

use val3_bytecode::{ContainerKind, ContainerRef, Op, Register, Subscript};
use val3_lang::memory::Lanes;

use crate::emitter::Emitter;
use crate::error::{CompileLimit, Result};
use crate::location::{CompiledValue, ValueLocator};

impl Emitter<'_, '_> {
    /// Looks up a value, and returns its place and the offset from there.
    pub(crate) fn located(&mut self, location: ValueLocator) -> Result<(Register, Lanes)> {
        if let ValueLocator::Place(place, lanes) = location {
            return Ok((place, lanes));
        }
        let to = self.frame.place()?;
        match location {
            ValueLocator::First(container, lanes) => {
                self.emit(Op::LocateFirst { to, container });
                Ok((to, lanes))
            }
            ValueLocator::Element { container, at, .. } => {
                self.emit(match at {
                    Subscript::One(index) => Op::Locate { to, container, index },
                    Subscript::Two([i, j]) => Op::Locate2 { to, container, i, j },
                    Subscript::Three([i, ..]) => Op::Locate3 { to, container, i },
                    Subscript::Whole => return Err(CompileLimit::Unclear),
                    Subscript::Key(key) => Op::LocateKey { to, container, key },
                });
                Ok((to, Lanes::default()))
            }
            ValueLocator::Frame(_) | ValueLocator::Place(..) | ValueLocator::Constant(_) => Err(CompileLimit::Unclear),
        }
    }

    /// Returns the location at an offset from `location`.
    pub(crate) fn after(&mut self, location: ValueLocator, offset: Lanes) -> Result<ValueLocator> {
        Ok(match location {
            ValueLocator::Frame(lanes) => ValueLocator::Frame(lanes + offset),
            ValueLocator::First(container, lanes) => ValueLocator::First(container, lanes + offset),
            ValueLocator::Element { .. } | ValueLocator::Place(..) | ValueLocator::Constant(_) => {
                let (place, lanes) = self.located(location)?;
                ValueLocator::Place(place, lanes + offset)
            }
        })
    }

    /// Looks up the container of the field with this number in a view.
    pub(crate) fn field_view(&mut self, of: ValueLocator, field: u16) -> Result<Register> {
        let op: Box<dyn Fn(Register) -> Op> = match of {
            ValueLocator::First(container, _) => Box::new(move |to| Op::FirstField { to, container, field }),
            ValueLocator::Element { container, at: Subscript::One(index), .. } => {
                Box::new(move |to| Op::ElementField { to, container, index, field })
            }
            location => {
                let (place, _) = self.located(location)?;
                Box::new(move |to| Op::Field { to, place, field })
            }
        };
        let to = self.frame.view()?;
        self.emit(op(to));
        Ok(to)
    }

    /// Returns the first value of the field with this number, in a user type.
    pub(crate) fn first_of_field(&mut self, of: CompiledValue, number: usize) -> Result<ValueLocator> {
        let field = u16::try_from(number).map_err(|_| CompileLimit::Items)?;
        let view = self.field_view(of.location, field)?;
        let container = ContainerRef::new(ContainerKind::View(view)).ok_or(CompileLimit::Containers)?;
        Ok(ValueLocator::First(container, Lanes::default()))
    }
}
