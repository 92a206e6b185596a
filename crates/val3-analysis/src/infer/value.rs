//! The value of an expression: a type, and whether it is a variable.

use smol_str::SmolStr;
use val3_lang::types::{BaseType, Container};

use crate::db::File;
use crate::ty::{Base, Ty};

/// The result of an expression.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Value {
    pub(super) base: Base,
    pub(super) form: Form,
}

/// Constant, variable or part of a variable.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Form {
    /// A constant or the result of a computation.
    Computed,
    /// A variable or field named without an index.
    Whole(Variable),
    /// A value in a container.
    Indexed {
        /// The container it lies in.
        of: Container,
    },
}

/// A variable or field as it was declared.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Variable {
    pub(super) container: Container,
    /// An array declared with one value, which is written and shown as an element (2.3.4).
    pub(super) single: bool,
    /// A parameter of the old dialect: an element or an array.
    pub(super) loose: bool,
    pub(super) origin: Origin,
}

/// Where a variable is declared.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Origin {
    Local,
    Parameter,
    /// A `.dtx`.
    Data(File, SmolStr),
    Builtin,
}

impl Value {
    pub(super) const UNKNOWN: Self = Self { base: Base::Unknown, form: Form::Computed };

    pub(super) fn computed(base: Base) -> Self {
        Self { base, form: Form::Computed }
    }

    pub(super) fn of(base: BaseType) -> Self {
        Self::computed(Base::of(base))
    }

    pub(super) fn is_unknown(&self) -> bool {
        self.base == Base::Unknown
    }

    /// A variable, or a part of one: it may be assigned and passed by reference.
    pub(super) fn is_variable(&self) -> bool {
        !matches!(self.form, Form::Computed) || self.is_unknown()
    }

    /// The declared container; an element after an index.
    pub(super) fn container(&self) -> Container {
        match &self.form {
            Form::Whole(variable) => variable.container,
            Form::Computed | Form::Indexed { .. } => Container::Element,
        }
    }

    pub(super) fn ty(&self) -> Ty {
        let container = match &self.form {
            Form::Whole(variable) if variable.single => Container::Element,
            _ => self.container(),
        };
        Ty { base: self.base, container }
    }

    /// The container cannot be read as one of its values: its index or key is missing.
    pub(super) fn lacks_index(&self) -> bool {
        matches!(self.container(), Container::Collection | Container::Array { dims: 2.. }) && !self.is_unknown()
    }
}
