//! Errors of compilation.

use std::fmt;

use smol_str::SmolStr;
use val3_analysis::db::FileRange;

/// A limit of the virtual controller that a project exceeds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CompileError {
    /// The path of the file.
    pub file: String,
    /// The line of the statement, from 1; 1 if the whole file is meant.
    pub row: u32,
    /// The limit.
    pub limit: Limit,
    /// The variable that exceeds it, if it is one.
    pub variable: Option<String>,
}

impl CompileError {
    /// An error at a line of a file.
    pub(crate) fn at(file: &str, row: u32, limit: Limit) -> Self {
        Self { file: file.to_string(), row, limit, variable: None }
    }
}

/// A limit that global data exceed, with the declaration.
#[derive(Debug)]
pub(crate) struct DataError {
    pub(crate) limit: Limit,
    /// The name, and where it is.
    pub(crate) datum: Option<(SmolStr, FileRange)>,
}

impl From<Limit> for DataError {
    fn from(limit: Limit) -> Self {
        Self { limit, datum: None }
    }
}

/// The kinds of limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit {
    /// Values that one program holds at a time: 65,535 of each sort.
    Registers,
    /// Containers of one program, of the global data, or used of libraries: 8,191.
    Containers,
    /// Programs, library identifiers, texts or fields of a type: 65,535.
    Items,
    /// Counters of one program that is compiled with counters: 65,536 lines and sides of branches.
    Counters,
    /// Operations of one program: 4,294,967,295.
    Operations,
    /// Bytes of global data: as many as a controller has memory.
    Memory,
    /// The analysis does not know the meaning of the code. A project with errors cannot be compiled.
    Unclear,
}

/// Turns [`Limit::Unclear`] into `None`: something is missing.
pub(crate) fn there<T>(made: Result<T>) -> Result<Option<T>> {
    match made {
        Err(Limit::Unclear) => Ok(None),
        made => made.map(Some),
    }
}

/// The result of a part of the compiler. The program adds the place of the error.
pub(crate) type Result<T> = std::result::Result<T, Limit>;

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Registers => "the program holds more than 65,535 values",
            Self::Containers => "there are more than 8,191 variables",
            Self::Items => "there are more than 65,535 programs, libraries, texts or fields",
            Self::Counters => "the program has more than 65,536 lines and sides of branches to count",
            Self::Operations => "the program is too long",
            Self::Memory => "the data need more memory than a controller has",
            Self::Unclear => "the meaning of this code is not known",
        })
    }
}

impl Limit {
    /// The remedy.
    #[must_use]
    pub fn help(self) -> &'static str {
        match self {
            Self::Registers | Self::Operations => "split the program into several that call one another",
            Self::Containers => "make one array, collection or user type of variables that belong together",
            Self::Items => "move programs and data to libraries",
            Self::Counters => "split the program, or leave it out by `//val3: no-coverage` before its first line",
            Self::Memory => "make arrays smaller, or read large data from files",
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
