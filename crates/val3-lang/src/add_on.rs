//! Instructions of add-ons, read at run time from the tables of a cell.
//!
//! A cell has one table for each add-on and kind of arm: `usr/app/val3.<Addon>.<anthro|scara|vrb>.cfx`. The types
//! correspond to [`crate::instruction`], with owned data.

mod param;
mod providers;
mod table;

use std::{error::Error, fmt};

use rustc_hash::FxHashMap;

pub use providers::providers;
pub use table::parse_table;

use crate::{
    instruction::{ArgumentForm, CallClass, Instruction, Overload},
    instructions,
    types::{Arm, BaseType},
};

/// An add-on's instructions for one kind of arm.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct AddOnTable {
    /// VAL 3 version as written in the table.
    pub version: Option<String>,
    instructions: Vec<AddOnInstruction>,
    /// Index in `instructions` by name.
    places: FxHashMap<String, usize>,
}

/// One instruction name with all its forms.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AddOnInstruction {
    /// Name with `$`.
    pub name: String,
    /// Forms, in file order.
    pub overloads: Vec<AddOnOverload>,
}

/// An instruction form.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AddOnOverload {
    /// Whether the form is called on a library identifier: `id:$libOpen()`.
    pub on_library: bool,
    /// Parameters in order.
    pub params: Vec<AddOnParam>,
    /// Type of the result; `None` without a result.
    pub result: Option<BaseType>,
    /// Whether the form can be a statement.
    pub class: CallClass,
}

/// An instruction parameter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AddOnParam {
    /// Generated name, because tables contain no names: the usual prefix of the type and the position, for example `j1`
    /// or `t2`.
    pub name: String,
    /// Type; `None` for any type, including types that this version does not support.
    pub ty: Option<BaseType>,
    /// Form of the argument.
    pub shape: ArgumentForm,
}

impl AddOnTable {
    /// Instructions, in file order.
    #[must_use]
    pub fn instructions(&self) -> &[AddOnInstruction] {
        &self.instructions
    }

    /// Finds an instruction by name, including `$`.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<&AddOnInstruction> {
        self.instructions.get(*self.places.get(name)?)
    }

    /// Adds a form to the instruction with this name.
    pub fn add(&mut self, name: String, overload: AddOnOverload) {
        let next = self.instructions.len();
        let place = *self.places.entry(name.clone()).or_insert(next);
        match self.instructions.get_mut(place) {
            Some(known) => known.overloads.push(overload),
            None => self.instructions.push(AddOnInstruction { name, overloads: vec![overload] }),
        }
    }
}

impl AddOnInstruction {
    /// Syntax lines of all forms, for example `num $velTool(tool t1, mdesc m2)`.
    #[must_use]
    pub fn signatures(&self) -> Vec<String> {
        self.overloads.iter().map(|overload| overload.signature(&self.name)).collect()
    }
}

impl AddOnOverload {
    /// Form of the catalogue with the same arguments, which implements `name` at run time. A form with exactly the same
    /// argument forms has priority over a form that differs in array or single variable.
    #[must_use]
    pub fn known(&self, name: &str) -> Option<(&'static Instruction, &'static Overload)> {
        let instruction = instructions::find(name)?;
        let mut forms = instruction.overloads.iter();
        let exact = forms.clone().find(|form| self.has_arguments_of(form, |known, own| known == own));
        let form = exact.or_else(|| {
            forms
                .find(|form| self.has_arguments_of(form, |known, own| known.is_by_reference() == own.is_by_reference()))
        })?;
        Some((instruction, form))
    }

    /// Whether a form of the catalogue has the same arguments, if `same` compares the argument forms.
    fn has_arguments_of(&self, form: &Overload, same: fn(ArgumentForm, ArgumentForm) -> bool) -> bool {
        let mut pairs = form.params.iter().zip(&self.params);
        form.on_library == self.on_library
            && form.params.len() == self.params.len()
            && pairs.all(|(known, own)| known.ty == own.ty && same(known.shape, own.shape))
    }

    /// Syntax line of this form; `name` is the instruction's name.
    #[must_use]
    pub fn signature(&self, name: &str) -> String {
        let result = self.result.map_or("void", BaseType::name);
        let library = if self.on_library { "library:" } else { "" };
        let params: Vec<String> = self.params.iter().map(ToString::to_string).collect();
        format!("{result} {library}{name}({})", params.join(", "))
    }
}

impl fmt::Display for AddOnParam {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.shape.write_param(f, self.ty, &self.name)
    }
}

/// Add-on and arm in the name of a table file, for example `val3.Velocity.anthro.cfx`, in upper or lower case.
#[must_use]
pub fn table_of_file(file_name: &str) -> Option<(&str, Arm)> {
    let mut parts = file_name.split('.');
    let (language, add_on, arm, ending) = (parts.next()?, parts.next()?, parts.next()?, parts.next()?);
    let is_table =
        language.eq_ignore_ascii_case("val3") && ending.eq_ignore_ascii_case("cfx") && parts.next().is_none();
    (is_table && !add_on.is_empty()).then_some((add_on, Arm::from_table_word(arm)?))
}

/// Error in a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableError {
    /// Byte offset in the text.
    pub offset: usize,
    /// Kind of the error.
    pub kind: TableErrorKind,
}

/// Kind of table error.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TableErrorKind {
    /// The text is not valid XML.
    Xml(String),
    /// The root element is not `Language`.
    NotATable,
    /// A function has no name.
    NoName,
    /// The result type of a function does not exist.
    UnknownResult(String),
    /// An array parameter has neither 1, 2 nor 3 dimensions.
    Dimensions(String),
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.kind {
            TableErrorKind::Xml(reason) => write!(f, "not readable as XML: {reason}"),
            TableErrorKind::NotATable => f.write_str("the root element is not `Language`"),
            TableErrorKind::NoName => f.write_str("a function has no name"),
            TableErrorKind::UnknownResult(name) => write!(f, "a function yields the unknown type `{name}`"),
            TableErrorKind::Dimensions(text) => write!(f, "an array has 1, 2 or 3 dimensions, not `{text}`"),
        }?;
        write!(f, " (at byte {})", self.offset)
    }
}

impl Error for TableError {}

#[cfg(test)]
mod tests {
    use super::{Arm, table_of_file};

    #[test]
    fn file_names_contain_add_on_and_arm() {
        assert_eq!(table_of_file("val3.Velocity.anthro.cfx"), Some(("Velocity", Arm::SixAxis)));
        assert_eq!(table_of_file("VAL3.Motion.SCARA.CFX"), Some(("Motion", Arm::Scara)));
        for other in ["val3.cfx", "val3.Motion.delta.cfx", "val3.Motion.vrb.cfx.bak", "cell.cfx", "val3..vrb.cfx"] {
            assert_eq!(table_of_file(other), None, "{other}");
        }
    }
}
