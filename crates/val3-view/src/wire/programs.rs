//! Message `programs`: the code of programs.

use schemars::JsonSchema;
use serde::Serialize;

/// Code of loaded programs. It is sent once, when the application or library is loaded, and
/// for changed files when a library is loaded again.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ProgramsMessage {
    /// Seconds of the controller's clock at which the code was loaded.
    pub t: f64,
    /// Name of the application or library.
    pub application: String,
    /// Programs whose files could be read.
    pub programs: Vec<ProgramCode>,
}

/// Code of a program, without XML.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ProgramCode {
    /// Program name.
    pub name: String,
    /// Path of the program's file.
    pub file: String,
    /// Line of the file with the first line of the code, from 1.
    pub line: u32,
    /// Lines of the code in their parts.
    pub code: Vec<Vec<CodePart>>,
}

/// Class and text of a code part.
pub type CodePart = (CodeClass, String);

/// Class of a part, for its colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum CodeClass {
    /// Names, operators and blanks.
    Text,
    /// Keyword.
    Keyword,
    /// Comment.
    Comment,
    /// String.
    String,
    /// Number.
    Number,
}
