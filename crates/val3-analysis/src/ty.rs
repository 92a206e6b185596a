//! Types as inferred by the analysis: a base and a container.

use smol_str::{SmolStr, format_smolstr};
use val3_lang::types::{Arm, BaseType, Container};

use crate::db::{Db, Project};

/// Maximum length of a string in bytes of UTF-8 (3.4.1).
pub(crate) const STRING_LIMIT: usize = 128;

/// Base of a type.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Base {
    /// A built-in type; positions may have a kind of arm.
    Builtin(BaseType, Option<Arm>),
    /// A user type, identified by its project.
    User(Project),
    /// An unknown type, which is the consequence of a reported fault and causes no further problems.
    Unknown,
}

/// A type: the base of the values, and the container that stores them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Ty {
    /// Base of the values.
    pub base: Base,
    /// Container of the values.
    pub container: Container,
}

impl Base {
    /// A built-in type without a kind of arm.
    pub const fn of(base: BaseType) -> Self {
        Self::Builtin(base, None)
    }

    /// Returns the type with the project's kind of arm, if it is a position type without one.
    pub fn on_arm(self, arm: Option<Arm>) -> Self {
        match self {
            Self::Builtin(base, None) if base.depends_on_arm() => Self::Builtin(base, arm),
            other => other,
        }
    }

    /// Returns the built-in type, if it is one.
    pub fn builtin(self) -> Option<BaseType> {
        match self {
            Self::Builtin(base, _) => Some(base),
            Self::User(_) | Self::Unknown => None,
        }
    }

    /// Whether the types are equal. Kinds of arm differ only if both are known.
    pub fn same_as(self, other: Self) -> bool {
        match (self, other) {
            (Self::Unknown, _) | (_, Self::Unknown) => true,
            (Self::User(a), Self::User(b)) => a == b,
            (Self::Builtin(a, arm), Self::Builtin(b, other)) => {
                a == b && !(arm.is_some() && other.is_some() && arm != other)
            }
            _ => false,
        }
    }

    /// Formats the type name as in a program.
    pub fn display(self, db: &dyn Db) -> SmolStr {
        match self {
            Self::Builtin(base, Some(arm)) if base.depends_on_arm() => base.file_name(arm).into(),
            Self::Builtin(base, _) => base.name().into(),
            Self::User(project) => project.manifest(db).path(db).file_stem().unwrap_or("?").into(),
            Self::Unknown => SmolStr::new_static("?"),
        }
    }
}

impl Ty {
    /// The unknown type.
    pub const UNKNOWN: Self = Self::element(Base::Unknown);

    /// The type of a single value.
    pub const fn element(base: Base) -> Self {
        Self { base, container: Container::Element }
    }

    /// The type of a single value of a built-in type.
    pub const fn of(base: BaseType) -> Self {
        Self::element(Base::of(base))
    }

    /// Whether the type is unknown.
    pub fn is_unknown(self) -> bool {
        self.base == Base::Unknown
    }

    /// Formats the type as in a program: `num`, `point[]`, `string[""]`, `num[,]`.
    pub fn display(self, db: &dyn Db) -> SmolStr {
        format_smolstr!("{}{}", self.base.display(db), brackets(self.container))
    }
}

/// Returns the brackets after the type or name: `[]`, `[,]`, `[""]`.
pub fn brackets(container: Container) -> &'static str {
    match container {
        Container::Element => "",
        Container::Array { dims: 0 | 1 } => "[]",
        Container::Array { dims: 2 } => "[,]",
        Container::Array { .. } => "[,,]",
        Container::Collection => "[\"\"]",
    }
}
