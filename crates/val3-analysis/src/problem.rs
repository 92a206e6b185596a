//! Problems found by the analysis, as values. The rules of `val3-check` create their messages.

mod kind;
mod modbus_table_fault;
mod page_fault;
mod refusal;

pub use kind::ProblemKind;
pub use modbus_table_fault::ModbusTableFault;
pub use page_fault::PageFault;

use smol_str::SmolStr;
use val3_syntax::encoding::Encoding;

use crate::db::FileRange;

/// A fault with its main location.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// The kind of fault.
    pub kind: ProblemKind,
    /// Main location.
    pub place: FileRange,
    /// Related locations, for example declarations or first occurrences.
    pub related: Vec<Related>,
}

/// A related location of a fault.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Related {
    /// Location.
    pub place: FileRange,
    /// Role of the location.
    pub role: RelatedRole,
}

/// Role of a related location.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RelatedRole {
    /// The declaration of the name.
    Declared,
    /// The parameter of the argument.
    Parameter,
    /// The first declaration, which the second one repeats.
    First,
    /// The interface that the library must implement.
    Interface,
    /// The differing item of the library.
    Implementation,
    /// The entry in the project file.
    Entry,
    /// The list in which an entry is missing.
    List,
    /// A use of the name.
    Use,
}

/// Kind of item that a name refers to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NameKind {
    /// Global data.
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

/// Role of a file in a project.
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
    /// Whether the fault is an unresolved name, which is the same at every use.
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

/// A fault in the encoding of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum EncodingFault {
    /// The file is neither UTF-8 nor declared as another encoding.
    NotUtf8,
    /// The file is declared as this encoding but stored as UTF-8.
    StoredAsUtf8(Encoding),
    /// The file declares an encoding that is not supported, and was read in this encoding.
    Unsupported(Encoding),
    /// The file is in this encoding, and an editor has read it in an encoding without its characters.
    Misread(Encoding),
    /// A character was replaced when the file was saved.
    Lost,
}

/// A variable and its memory.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct DataSize {
    /// Variable name.
    pub name: SmolStr,
    /// Size of the variable in bytes.
    pub bytes: u64,
    /// Size of this and all preceding variables of the file in bytes.
    pub total: u64,
}
