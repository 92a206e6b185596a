//! Types as the analysis computes them: a base and a container.

use smol_str::{SmolStr, format_smolstr};
use val3_lang::types::{Arm, BaseType, Container};

use crate::db::{Db, Project};

/// The longest string, in bytes of UTF-8 (3.4.1).
pub(crate) const STRING_LIMIT: usize = 128;

/// The base of a type.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Base {
    /// A built-in type; positions may be bound to an arm.
    Builtin(BaseType, Option<Arm>),
    /// A user type, named by its project.
    User(Project),
    /// Nothing is known, because something else is wrong: silent everywhere.
    Unknown,
}

/// A type: what each value is, and how the values are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Ty {
    /// The type of each value.
    pub base: Base,
    /// How the values are stored.
    pub container: Container,
}

impl Base {
    /// A built-in type of no particular arm.
    pub const fn of(base: BaseType) -> Self {
        Self::Builtin(base, None)
    }

    /// A position without an arm belongs to the arm of the project.
    pub fn on_arm(self, arm: Option<Arm>) -> Self {
        match self {
            Self::Builtin(base, None) if base.depends_on_arm() => Self::Builtin(base, arm),
            other => other,
        }
    }

    /// The built-in type, if it is one.
    pub fn builtin(self) -> Option<BaseType> {
        match self {
            Self::Builtin(base, _) => Some(base),
            Self::User(_) | Self::Unknown => None,
        }
    }

    /// Values of this type and of `other` are of the same type: arms differ only where both are known.
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

    /// The name as a programmer writes it.
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
    /// The type of nothing known.
    pub const UNKNOWN: Self = Self::element(Base::Unknown);

    /// One value.
    pub const fn element(base: Base) -> Self {
        Self { base, container: Container::Element }
    }

    /// One value of a built-in type.
    pub const fn of(base: BaseType) -> Self {
        Self::element(Base::of(base))
    }

    /// Nothing is known of it.
    pub fn is_unknown(self) -> bool {
        self.base == Base::Unknown
    }

    /// As a programmer writes it: `num`, `point[]`, `string[""]`, `num[,]`.
    pub fn display(self, db: &dyn Db) -> SmolStr {
        format_smolstr!("{}{}", self.base.display(db), brackets(self.container))
    }
}

/// The brackets after the type or name: `[]`, `[,]`, `[""]`.
pub fn brackets(container: Container) -> &'static str {
    match container {
        Container::Element => "",
        Container::Array { dims: 0 | 1 } => "[]",
        Container::Array { dims: 2 } => "[,]",
        Container::Array { .. } => "[,,]",
        Container::Collection => "[\"\"]",
    }
}
