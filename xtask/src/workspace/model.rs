//! A VAL 3 project, as the generator represents it.

/// Types in the workspace.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Type {
    Num,
    Bool,
    Text,
    Point,
    Joint,
    Trsf,
    Frame,
    Tool,
    Mdesc,
    Dio,
    /// User type of the workspace: `shared::SLOT`.
    Slot,
}

impl Type {
    /// Returns the name for parameters and locals.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Num => "num",
            Self::Bool => "bool",
            Self::Text => "string",
            Self::Point => "point",
            Self::Joint => "joint",
            Self::Trsf => "trsf",
            Self::Frame => "frame",
            Self::Tool => "tool",
            Self::Mdesc => "mdesc",
            Self::Dio => "dio",
            Self::Slot => "Slot",
        }
    }

    /// Returns the name in data files, where positions belong to an arm.
    pub(super) fn file_name(self) -> &'static str {
        match self {
            Self::Point => "pointRx",
            Self::Joint => "jointRx",
            other => other.name(),
        }
    }

    /// Returns the customary prefix of a name.
    pub(super) fn prefix(self) -> &'static str {
        match self {
            Self::Num => "n",
            Self::Bool => "b",
            Self::Text => "s",
            Self::Point => "p",
            Self::Joint => "j",
            Self::Trsf => "tr",
            Self::Frame => "f",
            Self::Tool => "t",
            Self::Mdesc => "m",
            Self::Dio => "d",
            Self::Slot => "u",
        }
    }
}

/// Number of values in a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Container {
    One,
    Array(usize),
    Grid(usize, usize),
    Collection(&'static [&'static str]),
}

/// Data, a parameter or a local.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Variable {
    pub(super) name: String,
    pub(super) ty: Type,
    pub(super) container: Container,
}

impl Variable {
    /// Creates a variable with one value.
    pub(super) fn one(name: impl Into<String>, ty: Type) -> Self {
        Self { name: name.into(), ty, container: Container::One }
    }
}

/// Data of a project.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Data {
    pub(super) variable: Variable,
    pub(super) public: bool,
}

/// A parameter of a program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Parameter {
    pub(super) variable: Variable,
    pub(super) by_reference: bool,
}

/// Signature of a program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Signature {
    /// `name`, or `library:name`.
    pub(super) name: String,
    pub(super) parameters: Vec<Parameter>,
}

/// A program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Program {
    pub(super) signature: Signature,
    pub(super) public: bool,
    pub(super) locals: Vec<Variable>,
    /// Lines from `begin` to `end`.
    pub(super) lines: Vec<String>,
}

/// A project that another project uses: the name of a user type or the identifier of a library, and its folder below
/// `usrapp`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct ReferencedProject {
    pub(super) name: &'static str,
    pub(super) folder: &'static str,
}

/// An application, a library or a user type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Project {
    pub(super) name: String,
    /// Folder below `usrapp`.
    pub(super) folder: String,
    pub(super) data: Vec<Data>,
    pub(super) programs: Vec<Program>,
    pub(super) libraries: Vec<ReferencedProject>,
    pub(super) types: Vec<ReferencedProject>,
}

impl Project {
    /// Returns the number of code lines, without blank lines and comments.
    pub(super) fn code_lines(&self) -> usize {
        self.programs.iter().flat_map(|program| &program.lines).filter(|line| is_code(line)).count()
    }
}

/// Whether the line is neither blank nor a comment.
pub(super) fn is_code(line: &str) -> bool {
    let line = line.trim_start();
    !line.is_empty() && !line.starts_with("//")
}
