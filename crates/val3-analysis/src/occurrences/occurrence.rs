//! A name in a file, with its symbol and usage.

use smol_str::SmolStr;
use val3_lang::types::BaseType;
use val3_syntax::TextRange;

use crate::db::{File, Project};

/// The symbol that a name refers to.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Symbol {
    /// A local variable of the program in a file.
    Local(File, SmolStr),
    /// A parameter of the program in a file.
    Param(File, SmolStr),
    /// Global data of a project. A field of a user type is data of the type's project.
    Data(Project, SmolStr),
    /// A program of a project.
    Program(Project, SmolStr),
    /// A library identifier of a project.
    Library(Project, SmolStr),
    /// Name of a user type in a project.
    Type(Project, SmolStr),
    /// A task that programs of a project create, named by a string.
    Task(Project, SmolStr),
    /// An element with this id in the HTML file of a user page.
    Element(File, SmolStr),
    /// An instruction.
    Instruction(SmolStr),
    /// A built-in variable or constant, for example `world`.
    Builtin(SmolStr),
    /// A value of an enumeration.
    Enumerator(SmolStr),
    /// A field of a built-in type.
    Field(BaseType, SmolStr),
    /// A built-in type.
    BuiltinType(SmolStr),
}

/// Usage of a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Usage {
    /// The name is declared.
    Declaration,
    /// The value is read, or the program is called.
    Read,
    /// The value is written.
    Write,
    /// The variable is passed by reference.
    Reference,
}

/// A name in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Occurrence {
    /// Range of the name only.
    pub range: TextRange,
    /// Symbol of the name.
    pub symbol: Symbol,
    /// Usage of the symbol.
    pub usage: Usage,
}
