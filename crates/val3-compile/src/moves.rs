//! Reading and writing values.

use val3_analysis::ty::Base;
use val3_bytecode::{CopySite, InstructionSite, Op, Operand, Register, Whole};
use val3_lang::memory::Lanes;
use val3_lang::operators::handlers;
use val3_lang::types::BaseType;

use crate::coder::Coder;
use crate::error::{Limit, Result};
use crate::frame::narrow;
use crate::places::num_register;
use crate::spot::{At, Spot, Value, is_number, text_lane};

impl Coder<'_, '_> {
    /// The register with a number, truth value or enumerator. The state of an input is read.
    pub(crate) fn load(&mut self, value: Value, want: Option<Lanes>) -> Result<Register> {
        if value.base.builtin() == Some(BaseType::Dio) {
            return self.read_digital(value, want);
        }
        if let Spot::Lanes(lanes) = value.spot {
            return Ok(num_register(lanes));
        }
        let to = self.num_result(want)?;
        match value.spot {
            Spot::First(whole, lanes) => {
                let lane = narrow(lanes.num);
                self.emit(Op::LoadFirst { to, whole, lane });
            }
            Spot::Element { whole, at: At::One(index), plain: true } => {
                self.emit(Op::LoadElement { to, whole, index });
            }
            Spot::Element { whole, at: At::Two(i, j), plain: true } => {
                self.emit(Op::LoadElement2 { to, whole, i, j });
            }
            spot => {
                let (place, lanes) = self.located(spot)?;
                self.emit(Op::Load { to, place, lane: narrow(lanes.num) });
            }
        }
        Ok(to)
    }

    fn read_digital(&mut self, value: Value, want: Option<Lanes>) -> Result<Register> {
        let to = self.num_result(want)?;
        let argument = self.argument_of(value)?;
        let run = handlers::assignment(BaseType::Bool, BaseType::Dio);
        let mut site = InstructionSite::named(ASSIGNMENT, run);
        site.arguments.push(argument);
        site.result = Some((Operand::Frame(Lanes::nums(to.into())), BaseType::Bool));
        self.code.instruction(site);
        Ok(to)
    }

    /// Writes a number, truth value or enumerator.
    pub(crate) fn store(&mut self, to: Spot, from: Register) -> Result<()> {
        match to {
            Spot::Lanes(lanes) => self.move_num(num_register(lanes), from),
            Spot::First(whole, lanes) => self.emit(Op::StoreFirst { whole, lane: narrow(lanes.num), from }),
            Spot::Element { whole, at: At::One(index), plain: true } => {
                self.emit(Op::StoreElement { whole, index, from });
            }
            Spot::Element { whole, at: At::Two(i, j), plain: true } => {
                self.emit(Op::StoreElement2 { whole, i, j, from });
            }
            spot => {
                let (place, lanes) = self.located(spot)?;
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

    /// The register with a text.
    pub(crate) fn load_text(&mut self, value: Value, want: Option<Lanes>) -> Result<Register> {
        if let Spot::Lanes(lanes) = value.spot {
            return Ok(narrow(lanes.text));
        }
        let to = self.text_result(want)?;
        let (place, _) = self.located(value.spot)?;
        self.emit(Op::LoadText { to, place });
        Ok(to)
    }

    /// Writes a text.
    fn store_text(&mut self, to: Spot, from: Register) -> Result<()> {
        match to {
            Spot::Lanes(lanes) if narrow(lanes.text) == from => {}
            Spot::Lanes(lanes) => self.emit(Op::TextMove { to: narrow(lanes.text), from }),
            spot => {
                let (place, _) = self.located(spot)?;
                self.emit(Op::StoreText { place, from });
            }
        }
        Ok(())
    }

    /// Where a value is, for operations that take it as it is.
    pub(crate) fn operand(&mut self, spot: Spot) -> Result<Operand> {
        if let Spot::Lanes(lanes) = spot {
            return Ok(Operand::Frame(lanes));
        }
        let (place, lanes) = self.located(spot)?;
        Ok(Operand::Place(place, lanes))
    }

    /// Makes a variable hold a value of its own type.
    pub(crate) fn copy(&mut self, to: Value, from: Value) -> Result<()> {
        match to.base.builtin() {
            Some(base) if is_number(base) => {
                let want = to.spot.lanes();
                let register = self.load(from, want)?;
                self.store(to.spot, register)
            }
            Some(BaseType::String) => {
                let want = to.spot.lanes();
                let register = self.load_text(from, want)?;
                self.store_text(to.spot, register)
            }
            _ if to.spot == from.spot => Ok(()),
            _ => {
                let site = self.copy_site(to.base, from.spot, to.spot)?;
                self.emit(Op::Copy { site });
                Ok(())
            }
        }
    }

    /// The copy of a value, or the comparison of two, as an entry of the table.
    pub(crate) fn copy_site(&mut self, base: Base, from: Spot, to: Spot) -> Result<u32> {
        let kind = self.kind(base)?;
        let (from, to) = (self.operand(from)?, self.operand(to)?);
        Ok(self.code.copy_site(CopySite { kind, from, to }))
    }

    /// A container of the frame that holds one value, and that value.
    pub(crate) fn own_container(&mut self, base: Base) -> Result<(Whole, Value)> {
        let kind = self.kind(base)?;
        let number = self.frame.part(kind, val3_lang::memory::Shape::ELEMENT)?;
        let whole = Whole::new(val3_bytecode::WholeKind::Part(number)).ok_or(Limit::Containers)?;
        Ok((whole, Value { spot: Spot::First(whole, Lanes::default()), base }))
    }

    /// A text of the program as a value.
    pub(crate) fn text_constant(&mut self, text: &smol_str::SmolStr, want: Option<Lanes>) -> Result<Value> {
        let (to, constant) = (self.text_result(want)?, self.code.text(text)?);
        self.emit(Op::TextConstant { to, constant });
        Ok(Value { spot: Spot::Lanes(text_lane(to)), base: Base::of(BaseType::String) })
    }
}

/// What messages call the site of an assignment.
pub(crate) const ASSIGNMENT: &str = "=";
