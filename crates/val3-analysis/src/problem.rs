//! Problems found by the analysis, as values. The rules of `val3-check` word them.

mod data_size;
mod encoding;
mod kind;
mod page_fault;
mod refusal;

pub use data_size::DataSize;
pub use encoding::EncodingFault;
pub use kind::ProblemKind;
pub use page_fault::PageFault;

use crate::db::FileRange;

/// One fault, with the place a person looks at first.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// The kind of fault.
    pub kind: ProblemKind,
    /// Where.
    pub place: FileRange,
    /// Other sides of the fault: declarations, first occurrences.
    pub related: Vec<Related>,
}

/// Another side of a fault.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Related {
    /// Where.
    pub place: FileRange,
    /// The role of that place.
    pub role: Role,
}

/// The role of the other side of a fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// The declaration of the name.
    Declared,
    /// The parameter that takes the argument.
    Parameter,
    /// The first of two equal things.
    First,
    /// The interface that the library has to fulfil.
    Interface,
    /// The item of the library that differs.
    Implementation,
    /// The entry in the project that leads here.
    Entry,
    /// The list that lacks an entry.
    List,
    /// One of the uses of the name.
    Use,
}

/// The kind of item that a name refers to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NameKind {
    /// A variable of the whole application.
    Data,
    /// A local variable.
    Local,
    /// A parameter.
    Parameter,
    /// A program.
    Program,
    /// An instruction.
    Instruction,
    /// A library identifier.
    Library,
    /// A user type.
    Type,
    /// A field of a user type.
    Field,
}

/// The role of a file in a project.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileRole {
    /// `.pjx`
    Project,
    /// `.pgx`
    Program,
    /// `.dtx`
    Data,
    /// The project of a library.
    Library,
    /// The project of a user type.
    Type,
}

impl ProblemKind {
    /// A declaration is missing: every use of the name has the same fault.
    pub fn is_about_missing_name(&self) -> bool {
        matches!(
            self,
            Self::UnknownName { .. }
                | Self::UnknownProgram { .. }
                | Self::UnknownInstruction { .. }
                | Self::UnknownLibrary { .. }
                | Self::LibraryItemUnknown { .. }
        )
    }
}
