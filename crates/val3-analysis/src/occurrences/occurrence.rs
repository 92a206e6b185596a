//! A name in a file, with its symbol and the kind of its use.

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
    /// The name by which a project calls a user type.
    Type(Project, SmolStr),
    /// A task that programs of a project create. Its name is a text.
    Task(Project, SmolStr),
    /// An element of the user page in an HTML file, by its id.
    Element(File, SmolStr),
    /// An instruction.
    Instruction(SmolStr),
    /// A variable or constant that is always there (`world`).
    Builtin(SmolStr),
    /// A value of an enumeration.
    Enumerator(SmolStr),
    /// A field of a built-in type.
    Field(BaseType, SmolStr),
    /// A built-in type.
    BuiltinType(SmolStr),
}

/// How a name is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Usage {
    /// It is declared here.
    Declaration,
    /// Its value is used, or it is called.
    Read,
    /// It gets a value.
    Write,
    /// It is handed over by reference.
    Reference,
}

/// A name in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Occurrence {
    /// The name alone.
    pub range: TextRange,
    /// Its symbol.
    pub symbol: Symbol,
    /// How it is used.
    pub usage: Usage,
}
