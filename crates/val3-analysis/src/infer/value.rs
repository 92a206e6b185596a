//! Values of expressions: the type, and whether it is a variable.

use smol_str::SmolStr;
use val3_lang::types::{BaseType, Container};

use crate::db::File;
use crate::ty::{Base, Ty};

/// Result of inferring an expression.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct InferredValue {
    pub(super) base: Base,
    pub(super) form: Form,
}

/// A constant, a variable or a part of a variable.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Form {
    /// A constant or computed value.
    Computed,
    /// A variable or field without an index.
    Whole(DeclaredVariable),
    /// An element of a container.
    Indexed {
        /// Container of the element.
        of: Container,
    },
}

/// A variable or field as declared.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DeclaredVariable {
    pub(super) container: Container,
    /// Whether it is an array with one element, which is written and shown as an element (2.3.4).
    pub(super) single: bool,
    /// Whether it is a parameter of the old dialect, which may be an element or an array.
    pub(super) loose: bool,
    pub(super) origin: VariableOrigin,
}

/// Origin of a variable's declaration.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum VariableOrigin {
    Local,
    Parameter,
    /// A data file, with the name of the data.
    Data(File, SmolStr),
    Builtin,
}

impl InferredValue {
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

    /// Whether it is a variable or a part of a variable, which may be assigned and passed by reference.
    pub(super) fn is_variable(&self) -> bool {
        !matches!(self.form, Form::Computed) || self.is_unknown()
    }

    /// Returns the declared container; `Element` after an index.
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

    /// Whether the container cannot be read as one value, so that an index or key is missing.
    pub(super) fn lacks_index(&self) -> bool {
        matches!(self.container(), Container::Collection | Container::Array { dims: 2.. }) && !self.is_unknown()
    }
}
