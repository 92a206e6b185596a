//! What keeps a project from being compiled.

use std::fmt;

use val3_bytecode::SourceRange;

/// A limit of the virtual controller that a project exceeds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CompileError {
    /// The path of the file.
    pub file: String,
    /// The statement or declaration.
    pub range: SourceRange,
    /// The limit.
    pub limit: Limit,
}

/// What there may not be more of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit {
    /// Values that one program holds at a time: 65,535 of each sort.
    Registers,
    /// Containers of one program, of the global data, or used of libraries: 8,191.
    Containers,
    /// Programs, library identifiers, texts or fields of a type: 65,535.
    Items,
    /// Operations of one program: 4,294,967,295.
    Operations,
    /// The analysis does not know what is meant: a project with errors cannot be compiled.
    Unclear,
}

/// What a part of the compiler returns; the program that it stands in adds the place.
pub(crate) type Result<T> = std::result::Result<T, Limit>;

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Registers => "the program holds more than 65,535 values",
            Self::Containers => "there are more than 8,191 variables",
            Self::Items => "there are more than 65,535 programs, libraries, texts or fields",
            Self::Operations => "the program is too long",
            Self::Unclear => "it cannot be told what is meant here",
        })
    }
}

impl fmt::Display for CompileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.file, self.limit)
    }
}

impl std::error::Error for CompileError {}
