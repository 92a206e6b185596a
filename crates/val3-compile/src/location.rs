//! Where values are.

use val3_analysis::ty::Base;
use val3_bytecode::{ContainerRef, Register, Subscript};
use val3_lang::memory::Lanes;
use val3_lang::types::BaseType;

use crate::frame::narrow;

/// A value: a variable that is read when it is needed, or a result.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Value {
    /// Where it is.
    pub(crate) location: Location,
    /// Its type.
    pub(crate) base: Base,
}

/// The location of a value, or the way to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Location {
    /// On the frame.
    Frame(Lanes),
    /// In the first value of a container, from these lanes of it on.
    First(ContainerRef, Lanes),
    /// A value of a container.
    Element {
        /// The container.
        container: ContainerRef,
        /// Which of its values.
        at: Subscript,
        /// It is a number or truth value, which is read and written without looking it up.
        plain: bool,
    },
    /// In a value that was looked up, from these lanes of it on.
    Place(Register, Lanes),
    /// A text constant of the program.
    Constant(u16),
}

impl Value {
    /// A value of a built-in type on the frame.
    pub(crate) fn on_frame(base: BaseType, lanes: Lanes) -> Self {
        Self { location: Location::Frame(lanes), base: Base::of(base) }
    }

    /// A number, truth value or enumerator in a register.
    pub(crate) fn num(base: BaseType, register: Register) -> Self {
        Self::on_frame(base, Lanes::nums(register.into()))
    }

    /// A text in a register.
    pub(crate) fn text(register: Register) -> Self {
        Self::on_frame(BaseType::String, Lanes { text: register.into(), ..Lanes::default() })
    }
}

impl Location {
    /// The lanes, where it is on the frame.
    pub(crate) fn lanes(self) -> Option<Lanes> {
        match self {
            Self::Frame(lanes) => Some(lanes),
            _ => None,
        }
    }
}

/// A type whose values are one number: numbers, truth values and enumerators.
pub(crate) fn is_number(base: BaseType) -> bool {
    matches!(base, BaseType::Num | BaseType::Bool) || base.is_enumeration()
}

/// The register of a number that lies on the frame.
pub(crate) fn num_register(lanes: Lanes) -> Register {
    narrow(lanes.num)
}
