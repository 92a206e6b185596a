//! Where values are.

use val3_analysis::ty::Base;
use val3_bytecode::{Register, Whole};
use val3_lang::memory::Lanes;
use val3_lang::types::BaseType;

/// A value: a variable that is read when it is needed, or a result.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Value {
    /// Where it is.
    pub(crate) spot: Spot,
    /// Its type.
    pub(crate) base: Base,
}

/// Where a value is, or how it is reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Spot {
    /// On the frame.
    Lanes(Lanes),
    /// In the first value of a container, so many lanes behind its start.
    First(Whole, Lanes),
    /// A value of a container.
    Element {
        /// The container.
        whole: Whole,
        /// Which of its values.
        at: At,
        /// It is a number or truth value, which is read and written without looking it up.
        plain: bool,
    },
    /// So many lanes behind a place.
    Place(Register, Lanes),
}

/// Which value of a container.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum At {
    /// Under an index.
    One(Register),
    /// Under two indexes.
    Two(Register, Register),
    /// Under three indexes that follow one another.
    Three(Register),
    /// Under a key.
    Key(Register),
}

impl Value {
    /// A value of a built-in type on the frame.
    pub(crate) fn on_frame(base: BaseType, lanes: Lanes) -> Self {
        Self { spot: Spot::Lanes(lanes), base: Base::of(base) }
    }

    /// A number, truth value or enumerator in a register.
    pub(crate) fn num(base: BaseType, register: Register) -> Self {
        Self::on_frame(base, Lanes::nums(register.into()))
    }

    /// A text in a register.
    pub(crate) fn text(register: Register) -> Self {
        Self::on_frame(BaseType::String, text_lane(register))
    }
}

impl Spot {
    /// The lanes, where it is on the frame.
    pub(crate) fn lanes(self) -> Option<Lanes> {
        match self {
            Self::Lanes(lanes) => Some(lanes),
            _ => None,
        }
    }
}

/// The lanes of a text.
pub(crate) fn text_lane(register: Register) -> Lanes {
    Lanes { text: register.into(), ..Lanes::default() }
}

/// A type whose values are one number: numbers, truth values and enumerators.
pub(crate) fn is_number(base: BaseType) -> bool {
    matches!(base, BaseType::Num | BaseType::Bool) || base.is_enumeration()
}
