//! The shape of the instruction catalogue: what a row says.

use std::hash::{Hash, Hasher};

use crate::call::InstructionFn;
use crate::{types::BaseType, versions::Version};

mod effects;
mod syntax;

/// One instruction name with all its forms.
#[derive(Debug)]
pub struct Instruction {
    /// The name in code (`movej`, `$fileOpen`).
    pub name: &'static str,
    /// The family it belongs to, as the manual's chapters group them.
    pub family: Family,
    /// Section of the manual ("10.6"), several for names shared by types ("2.5.4, 3.4.3"); empty for additions.
    pub section: &'static str,
    /// The page in Markdown, one leading blank a line: what it does, parameters with units, result, errors, an
    /// example. [`crate::page`] cuts it into its parts.
    pub page: &'static str,
    /// Every form, in the manual's order.
    pub overloads: &'static [Overload],
    /// The scheduler moves on to the next task while it waits (5.4).
    pub blocking: bool,
    /// Numbers of the run-time errors it can raise (12.1), ascending.
    pub errors: &'static [u16],
    /// Where it exists.
    pub availability: Availability,
}

/// One form of an instruction.
#[derive(Debug)]
pub struct Overload {
    /// It is called on a library identifier: `id:libLoad(…)`.
    pub on_library: bool,
    /// Parameters in order.
    pub params: &'static [Param],
    /// The value it yields; `None` for no value.
    pub result: Option<BaseType>,
    /// Whether it can be a statement of its own. Forms of one name differ: `insert` of a container acts, `insert` of a
    /// string only yields the new string.
    pub class: Class,
    /// First major version with this form, where the form is younger than the instruction.
    pub since: Option<u8>,
    /// Whether the manual prints the form. Other forms are known from programs that run on controllers.
    pub is_printed: bool,
    /// Its handler; `None` if the virtual controller does not have the instruction.
    pub run: Option<InstructionFn>,
}

/// One parameter of an instruction.
#[derive(Debug, PartialEq, Eq)]
pub struct Param {
    /// Name in the syntax line (`nSeconds`).
    pub name: &'static str,
    /// Its type; `None` means any type.
    pub ty: Option<BaseType>,
    /// The kind of argument.
    pub shape: Shape,
}

/// The kind of an argument.
///
/// An element counts as an array of one value (2.3.4), so `x`, `x[3]` and `x["k"]` all suit `Array { dims: 1 }`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// Any expression of the type: passed by value.
    Value,
    /// A variable (or an element of one): passed by reference (2.6.2).
    Reference,
    /// An array, or a one-dimensional array from an index on (2.6.3).
    Array {
        /// Number of dimensions, 1 to 3.
        dims: u8,
    },
    /// A whole collection, without a key (`first`, `last`).
    Collection,
    /// The name of a whole container: an array or a collection; a one-dimensional array may have an index that
    /// says where a part of it starts (`size`, `resize`, `append`).
    Whole,
    /// A place in a container: an index or key that need not exist (`insert`, `delete`, `next`, `prev`).
    Slot,
    /// A place in a container or the whole variable; either need not exist (`isDefined`).
    Item,
    /// The call of a program with its arguments (`taskCreate`).
    ProgramCall,
}

/// Families of instructions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Family {
    /// All variables, arrays and collections (2.5).
    Variables,
    /// Numbers (3.2).
    Numbers,
    /// Bit fields and binary formats (3.3).
    Bits,
    /// Strings (3.4).
    Strings,
    /// Digital, numerical and serial inputs and outputs (3.5 to 3.7).
    Io,
    /// Pendant screen, keys, log and date (4).
    Screen,
    /// Tasks and time (5).
    Tasks,
    /// Libraries (6).
    Libraries,
    /// Power, modes, speed and versions (8).
    Controller,
    /// Positions and geometry (9).
    Geometry,
    /// Motion (10.6).
    Motion,
    /// Options: force, alter, licences, absolute robot, continuous axes (11).
    Options,
    /// s8 user pages, safety and the other additions to the manual.
    Additions,
    /// Files, lists and the other instructions of add-ons.
    AddOns,
}

/// Where an instruction exists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Availability {
    /// In every version from s7 on (the v7 manual).
    Manual,
    /// From major version `since` on (8 for s8, CS9), or in old versions only where `until` says so.
    Version {
        /// First major version that has it; 0 where it is not known.
        since: u8,
        /// Last major version that has it, where it was dropped.
        until: Option<u8>,
    },
    /// Only where the add-on is installed; the best known of the add-ons that have it.
    AddOn(&'static str),
}

/// Whether a line may consist of the call alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// It only yields a value; alone on a line it has no effect, which the compiler refuses.
    Function,
    /// It acts; its value, if any, may be dropped.
    Modifier,
}

impl Instruction {
    /// Every form as a syntax line, in the manual's order: `num sin(num nAngle)`.
    #[must_use]
    pub fn signatures(&self) -> Vec<String> {
        self.overloads.iter().map(|overload| overload.signature(self.name)).collect()
    }

    /// Whether a controller of this version has the instruction without an add-on.
    ///
    /// Instructions of the manual count as present in every version: the gaps of s5 and s6 are not known.
    #[must_use]
    pub fn exists_in(&self, version: Version) -> bool {
        match self.availability {
            Availability::Manual => true,
            Availability::Version { since, until } => {
                version.language() >= since && until.is_none_or(|last| version.language() <= last)
            }
            Availability::AddOn(_) => false,
        }
    }

    /// The add-on that brings the instruction, if it comes with one.
    #[must_use]
    pub fn add_on(&self) -> Option<&'static str> {
        match self.availability {
            Availability::AddOn(name) => Some(name),
            Availability::Manual | Availability::Version { .. } => None,
        }
    }
}

/// Names are unique in the catalogue: equal names are the same instruction.
impl PartialEq for Instruction {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Instruction {}

impl Hash for Instruction {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}

/// Forms are equal where they are the same form of the catalogue.
impl PartialEq for Overload {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Eq for Overload {}

impl Overload {
    /// Whether a controller of this version has the form, given that it has the instruction.
    #[must_use]
    pub fn exists_in(&self, version: Version) -> bool {
        self.since.is_none_or(|since| version.language() >= since)
    }
}

/// Rows are built by the macro `instruction`: the clauses of its head line are these methods.
impl Instruction {
    pub(crate) const fn new(name: &'static str, family: Family) -> Self {
        Self {
            name,
            family,
            section: "",
            page: "",
            overloads: &[],
            blocking: false,
            errors: &[],
            availability: Availability::Manual,
        }
    }

    pub(crate) const fn described(self, section: &'static str, page: &'static str) -> Self {
        Self { section, page, ..self }
    }

    pub(crate) const fn forms(self, overloads: &'static [Overload]) -> Self {
        Self { overloads, ..self }
    }

    pub(crate) const fn blocking(self) -> Self {
        Self { blocking: true, ..self }
    }

    pub(crate) const fn errors(self, errors: &'static [u16]) -> Self {
        Self { errors, ..self }
    }

    pub(crate) const fn since(self, since: u8) -> Self {
        Self { availability: Availability::Version { since, until: None }, ..self }
    }

    pub(crate) const fn until(self, last: u8) -> Self {
        Self { availability: Availability::Version { since: 0, until: Some(last) }, ..self }
    }

    pub(crate) const fn with_add_on(self, name: &'static str) -> Self {
        Self { availability: Availability::AddOn(name), ..self }
    }
}
