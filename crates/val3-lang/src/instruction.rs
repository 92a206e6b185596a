//! Types of the instruction catalogue.

use std::hash::{Hash, Hasher};

use crate::call::InstructionFn;
use crate::motion::MotionRole;
use crate::{types::BaseType, versions::Version};

mod effects;
mod syntax;

/// One instruction name with all its forms.
#[derive(Debug)]
pub struct Instruction {
    /// Name in code (`movej`, `$fileOpen`).
    pub name: &'static str,
    /// Family, as in the manual's chapters.
    pub family: Family,
    /// Section of the manual ("10.6"), or several sections if types share the name ("2.5.4, 3.4.3"); empty for
    /// additions.
    pub section: &'static str,
    /// Page in Markdown, with one leading blank per line: description, parameters with units, result, errors and an
    /// example. [`crate::page`] splits it into parts.
    pub page: &'static str,
    /// Forms, in the manual's order.
    pub overloads: &'static [Overload],
    /// Whether the scheduler continues with the next task while the instruction waits (5.4).
    pub blocking: bool,
    /// Effect on the recorded moves; `None` without an effect.
    pub role: Option<MotionRole>,
    /// Numbers of the run-time errors it can raise (12.1), ascending.
    pub errors: &'static [u16],
    /// Versions and add-ons with the instruction.
    pub availability: Availability,
}

/// An instruction form.
#[derive(Debug)]
pub struct Overload {
    /// Whether the form is called on a library identifier: `id:libLoad(…)`.
    pub on_library: bool,
    /// Parameters in order.
    pub params: &'static [InstructionParam],
    /// Type of the result; `None` without a result.
    pub result: Option<BaseType>,
    /// Whether the form can be a statement. Forms with the same name may differ: `insert` modifies a container, but
    /// only returns the new string for a string.
    pub class: CallClass,
    /// First major version with this form, if it was added after the instruction.
    pub since: Option<u8>,
    /// Whether the form is in the manual. Other forms are known from programs that run on controllers.
    pub is_printed: bool,
    /// Handler; `None` if the virtual controller does not support the instruction.
    pub run: Option<InstructionFn>,
}

/// An instruction parameter.
#[derive(Debug, PartialEq, Eq)]
pub struct InstructionParam {
    /// Name in the syntax line (`nSeconds`).
    pub name: &'static str,
    /// Type; `None` for any type.
    pub ty: Option<BaseType>,
    /// Form of the argument.
    pub shape: ArgumentForm,
}

/// Argument form.
///
/// An element counts as an array with one value (2.3.4), so `x`, `x[3]` and `x["k"]` all match `Array { dims: 1 }`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArgumentForm {
    /// An expression of the type, passed by value.
    Value,
    /// A variable or an element, passed by reference (2.6.2).
    Reference,
    /// An array, or a one-dimensional array from an index (2.6.3).
    Array {
        /// Number of dimensions, 1 to 3.
        dims: u8,
    },
    /// A collection without a key (`first`, `last`).
    Collection,
    /// The name of a container: an array or a collection. A one-dimensional array may have the index at which a part of
    /// it begins (`size`, `resize`, `append`).
    Whole,
    /// An element, by an index or key that need not exist (`insert`, `delete`, `next`, `prev`).
    Slot,
    /// An element or a variable that need not exist (`isDefined`).
    Item,
    /// The call of a program with its arguments (`taskCreate`).
    ProgramCall,
}

/// Instruction family.
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

/// Versions and add-ons with an instruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Availability {
    /// In every version from s7 on (the v7 manual).
    Manual,
    /// From major version `since` on (8 for s8, CS9), or only in versions up to `until`.
    Version {
        /// First major version; 0 if unknown.
        since: u8,
        /// Last major version, if the instruction was removed.
        until: Option<u8>,
    },
    /// Only with an add-on. The value is the best known add-on with the instruction.
    AddOn(&'static str),
}

/// Whether the call can be a statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CallClass {
    /// Only returns a value. As a statement it would have no effect, so the compiler rejects it.
    Function,
    /// Has an effect; its value, if any, may be discarded.
    Modifier,
}

impl Instruction {
    /// Syntax lines of all forms, in the manual's order: `num sin(num nAngle)`.
    #[must_use]
    pub fn signatures(&self) -> Vec<String> {
        self.overloads.iter().map(|overload| overload.signature(self.name)).collect()
    }

    /// Whether a controller of this version has the instruction without an add-on.
    ///
    /// Instructions in the manual count as present in every version, because the restrictions of s5 and s6 are unknown.
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

    /// Add-on that contains the instruction.
    #[must_use]
    pub fn add_on(&self) -> Option<&'static str> {
        match self.availability {
            Availability::AddOn(name) => Some(name),
            Availability::Manual | Availability::Version { .. } => None,
        }
    }
}

/// Instructions with equal names are equal, because names are unique in the catalogue.
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

/// Forms are equal only if they are the same catalogue entry.
impl PartialEq for Overload {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Eq for Overload {}

impl Overload {
    /// Whether a controller of this version has the form, provided that it has the instruction.
    #[must_use]
    pub fn exists_in(&self, version: Version) -> bool {
        self.since.is_none_or(|since| version.language() >= since)
    }
}

/// Builder methods for the macro `instruction`: one for each clause in its first line.
impl Instruction {
    pub(crate) const fn new(name: &'static str, family: Family) -> Self {
        Self {
            name,
            family,
            section: "",
            page: "",
            overloads: &[],
            blocking: false,
            role: None,
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

    pub(crate) const fn role(self, role: MotionRole) -> Self {
        Self { role: Some(role), ..self }
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
