//! Errors of compilation.

use std::fmt;

use smol_str::SmolStr;
use val3_analysis::db::FileRange;

/// Error: a project exceeds a limit of the virtual controller.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CompileError {
    /// Path of the file.
    pub file: String,
    /// Line of the statement, from 1; 1 for the entire file.
    pub row: u32,
    /// Limit.
    pub limit: CompileLimit,
    /// Variable that exceeds the limit; `None` if it is not a variable.
    pub variable: Option<String>,
}

impl CompileError {
    /// Creates an error at a line of a file.
    pub(crate) fn at(file: &str, row: u32, limit: CompileLimit) -> Self {
        Self { file: file.to_string(), row, limit, variable: None }
    }
}

/// Error: global data exceed a limit.
#[derive(Debug)]
pub(crate) struct DataError {
    pub(crate) limit: CompileLimit,
    /// Name, and location of the declaration.
    pub(crate) datum: Option<(SmolStr, FileRange)>,
}

impl From<CompileLimit> for DataError {
    fn from(limit: CompileLimit) -> Self {
        Self { limit, datum: None }
    }
}

/// Limits of compilation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CompileLimit {
    /// Values that a program holds at the same time: 65,535 of each kind.
    Registers,
    /// Containers in a program, in the global data, or used from libraries: 8,191.
    Containers,
    /// Programs, library identifiers, strings, or fields of a type: 65,535.
    Items,
    /// Counters in a program that is compiled with counters: 65,536 lines and branch sides.
    Counters,
    /// Operations in a program: 4,294,967,295.
    Operations,
    /// Size of the global data: the memory of a controller.
    Memory,
    /// The analysis has not resolved the code. A project with errors cannot be compiled.
    Unclear,
}

/// Converts [`CompileLimit::Unclear`] to `None`: the line uses something unresolved.
pub(crate) fn there<T>(made: Result<T>) -> Result<Option<T>> {
    match made {
        Err(CompileLimit::Unclear) => Ok(None),
        made => made.map(Some),
    }
}

/// Result from a part of the compiler. The program adds the error's location.
pub(crate) type Result<T> = std::result::Result<T, CompileLimit>;

impl fmt::Display for CompileLimit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Registers => "the program has more than 65,535 values",
            Self::Containers => "there are more than 8,191 variables",
            Self::Items => "there are more than 65,535 programs, libraries, texts or fields",
            Self::Counters => "the program has more than 65,536 lines and sides of branches to count",
            Self::Operations => "the program is too long",
            Self::Memory => "the data need more memory than a controller has",
            Self::Unclear => "this code cannot be resolved",
        })
    }
}

impl CompileLimit {
    /// Returns the remedy, for users.
    #[must_use]
    pub fn help(self) -> &'static str {
        match self {
            Self::Registers | Self::Operations => "split the program into several that call one another",
            Self::Containers => "combine related variables in an array, a collection or a user type",
            Self::Items => "move programs and data to libraries",
            Self::Counters => "split the program, or exclude it by `//val3: no-coverage` before its first line",
            Self::Memory => "reduce array sizes, or read large data from files",
            Self::Unclear => {
                "run `val3 check`; if it reports nothing here, a comment or `val3.toml` silences the finding"
            }
        }
    }
}

impl fmt::Display for CompileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.file, self.row, self.limit)?;
        self.variable.as_ref().map_or(Ok(()), |name| write!(f, " (`{name}`)"))
    }
}

impl std::error::Error for CompileError {}
