//! Names, indexes and fields: the variable, or the part of one, that an expression names (2.5.2, 2.5.3).

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::ty::Base;
use val3_bytecode::{Op, Register, Storage, Whole, WholeKind};
use val3_lang::memory::{Lanes, enumerator, field_offset};
use val3_lang::types::BaseType;
use val3_lang::{builtins, enumerations};

use crate::coder::Coder;
use crate::error::{Limit, Result};
use crate::frame::narrow;
use crate::spot::{At, Spot, Value};

impl Coder<'_, '_> {
    /// The variable that an expression names; `None` for a value that is computed.
    pub(crate) fn variable(&mut self, id: ExprId) -> Result<Option<Value>> {
        let base = self.base(id);
        let spot = match self.body.expr(id) {
            Expr::Paren(inner) => return self.variable(*inner),
            Expr::Name(name) => match self.frame.find(name) {
                Some(Storage::Value(lanes)) => Some(Spot::Lanes(lanes)),
                Some(Storage::Place(place)) => Some(Spot::Place(place, Lanes::default())),
                Some(_) | None => self.whole(id)?.map(first),
            },
            Expr::Path { .. } => self.whole(id)?.map(first),
            Expr::Index(of, indexes) => Some(self.element(*of, indexes, base)?),
            Expr::Field { base: of, field, .. } => match self.base(*of) {
                Base::User(_) => self.whole(id)?.map(first),
                _ => Some(self.field(*of, field)?),
            },
            _ => None,
        };
        Ok(spot.map(|spot| Value { spot, base }))
    }

    /// The container that an expression names without an index; `None` where it is no container of its own.
    pub(crate) fn whole(&mut self, id: ExprId) -> Result<Option<Whole>> {
        let kind = match self.body.expr(id) {
            Expr::Name(name) => match self.frame.find(name) {
                Some(Storage::Part(number)) => Some(WholeKind::Part(number)),
                Some(Storage::View(number)) => Some(WholeKind::View(number)),
                Some(Storage::Value(_) | Storage::Place(_)) => None,
                None => self.global(name),
            },
            Expr::Path { library, item } => Some(WholeKind::Import(self.unit.import_data(library, item)?)),
            Expr::Field { base, field, .. } => match self.base(*base) {
                Base::User(_) => Some(WholeKind::View(self.user_field(*base, field)?)),
                _ => None,
            },
            _ => None,
        };
        kind.map(|kind| Whole::new(kind).ok_or(Limit::Containers)).transpose()
    }

    /// Global data, or a variable that every application has.
    fn global(&self, name: &str) -> Option<WholeKind> {
        let builtin = || builtins::BUILTINS.iter().position(|builtin| builtin.is_variable && builtin.name == name);
        let number = |at| u16::try_from(at).ok();
        self.unit.data(name).map(WholeKind::Data).or_else(|| builtin().and_then(number).map(WholeKind::Builtin))
    }

    /// `of[indexes]`
    fn element(&mut self, of: ExprId, indexes: &[ExprId], base: Base) -> Result<Spot> {
        let whole = self.whole(of)?.ok_or(Limit::Unclear)?;
        let plain = matches!(base.builtin(), Some(BaseType::Num | BaseType::Bool));
        Ok(Spot::Element { whole, at: self.at(indexes)?, plain })
    }

    fn at(&mut self, indexes: &[ExprId]) -> Result<At> {
        Ok(match *indexes {
            [key] if self.base(key).builtin() == Some(BaseType::String) => At::Key(self.text(key)?),
            [index] => At::One(self.num(index)?),
            [i, j] => At::Two(self.num(i)?, self.num(j)?),
            [_, _, _] => At::Three(self.run(indexes)?),
            _ => return Err(Limit::Unclear),
        })
    }

    /// The numbers of some expressions in registers that follow one another; the first of them.
    pub(crate) fn run(&mut self, ids: &[ExprId]) -> Result<Register> {
        let first = self.frame.nums(u32::try_from(ids.len()).map_err(|_| Limit::Registers)?)?;
        for (to, id) in (first..).zip(ids) {
            self.num_to(*id, to)?;
        }
        Ok(first)
    }

    /// A field of a built-in type: lanes of its value.
    fn field(&mut self, of: ExprId, field: &str) -> Result<Spot> {
        let value = self.value(of, None)?;
        let Base::Builtin(base, arm) = value.base else { return Err(Limit::Unclear) };
        let offset = field_offset(base, arm.or(self.unit.items.arm), field).ok_or(Limit::Unclear)?;
        self.behind(value.spot, offset)
    }

    /// The spot so many lanes behind another.
    pub(crate) fn behind(&mut self, spot: Spot, offset: Lanes) -> Result<Spot> {
        Ok(match spot {
            Spot::Lanes(lanes) => Spot::Lanes(lanes + offset),
            Spot::First(whole, lanes) => Spot::First(whole, lanes + offset),
            Spot::Element { .. } | Spot::Place(..) => {
                let (place, lanes) = self.located(spot)?;
                Spot::Place(place, lanes + offset)
            }
        })
    }

    /// The container of a field of a user type, looked up into a view.
    fn user_field(&mut self, of: ExprId, field: &str) -> Result<Register> {
        let value = self.variable(of)?.ok_or(Limit::Unclear)?;
        let kind = self.kind(value.base)?;
        let number = kind.fields.iter().position(|known| known.name == field).ok_or(Limit::Unclear)?;
        let field = u16::try_from(number).map_err(|_| Limit::Items)?;
        let (place, _) = self.located(value.spot)?;
        let to = self.frame.view()?;
        self.emit(Op::Field { to, place, field });
        Ok(to)
    }

    /// Looks a value up: its place, and how many lanes behind that it is.
    pub(crate) fn located(&mut self, spot: Spot) -> Result<(Register, Lanes)> {
        if let Spot::Place(place, lanes) = spot {
            return Ok((place, lanes));
        }
        let to = self.frame.place()?;
        match spot {
            Spot::First(whole, lanes) => {
                self.emit(Op::LocateFirst { to, whole });
                Ok((to, lanes))
            }
            Spot::Element { whole, at, .. } => {
                self.emit(match at {
                    At::One(index) => Op::Locate { to, whole, index },
                    At::Two(i, j) => Op::Locate2 { to, whole, i, j },
                    At::Three(i) => Op::Locate3 { to, whole, i },
                    At::Key(key) => Op::LocateKey { to, whole, key },
                });
                Ok((to, Lanes::default()))
            }
            Spot::Lanes(_) | Spot::Place(..) => Err(Limit::Unclear),
        }
    }

    /// The number that a name stands for, if it is that of an enumerator and of nothing nearer.
    pub(crate) fn enumerator(&self, name: &str) -> Option<f64> {
        let hidden = self.frame.find(name).is_some() || self.global(name).is_some();
        enumerations::find(name).filter(|_| !hidden).map(|found| enumerator(found.name))
    }
}

fn first(whole: Whole) -> Spot {
    Spot::First(whole, Lanes::default())
}

/// The register of a number that lies on the frame.
pub(crate) fn num_register(lanes: Lanes) -> Register {
    narrow(lanes.num)
}
