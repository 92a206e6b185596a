//! Locations of values.

use val3_analysis::ty::Base;
use val3_bytecode::{ContainerRef, Register, Subscript};
use val3_lang::memory::Lanes;
use val3_lang::types::BaseType;

use crate::frame::narrow;

/// A value: a variable that is read when it is used, or a result.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CompiledValue {
    /// Location.
    pub(crate) location: ValueLocator,
    /// Type.
    pub(crate) base: Base,
}

/// Location of a value, or the lookup that it requires.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ValueLocator {
    /// On the frame.
    Frame(Lanes),
    /// In the first value of a container, from these lanes on.
    First(ContainerRef, Lanes),
    /// A container element.
    Element {
        /// Container.
        container: ContainerRef,
        /// Index or key.
        at: Subscript,
        /// Whether it is a number or truth value, which is read and written without a lookup.
        plain: bool,
    },
    /// In a value that was looked up, from these lanes on.
    Place(Register, Lanes),
    /// A string constant of the program.
    Constant(u16),
}

impl CompiledValue {
    /// Creates a value with a built-in type on the frame.
    pub(crate) fn on_frame(base: BaseType, lanes: Lanes) -> Self {
        Self { location: ValueLocator::Frame(lanes), base: Base::of(base) }
    }

    /// Creates a number, truth value or enumerator in a register.
    pub(crate) fn num(base: BaseType, register: Register) -> Self {
        Self::on_frame(base, Lanes::nums(register.into()))
    }

    /// Creates a string in a register.
    pub(crate) fn text(register: Register) -> Self {
        Self::on_frame(BaseType::String, Lanes { text: register.into(), ..Lanes::default() })
    }
}

impl ValueLocator {
    /// Returns the lanes if the location is on the frame.
    pub(crate) fn lanes(self) -> Option<Lanes> {
        match self {
            Self::Frame(lanes) => Some(lanes),
            _ => None,
        }
    }
}

/// Whether values of the type are one number: numbers, truth values and enumerators.
pub(crate) fn is_number(base: BaseType) -> bool {
    matches!(base, BaseType::Num | BaseType::Bool) || base.is_enumeration()
}

/// Returns the register of a number on the frame.
pub(crate) fn num_register(lanes: Lanes) -> Register {
    narrow(lanes.num)
}
