//! Differences between two trees, as plain data for renderers and other programs. They contain no references to files.

mod application;
mod change;
mod class;
mod data;
mod program;
mod text;

use serde::Serialize;

pub use application::{ApplicationChange, ContentChange, InterfaceChange, ItemKind, ProjectChange, ReferenceChange};
pub use change::{Change, ValuePair};
pub use class::ReportClass;
pub use data::{
    DataChange, Dependent, Displacement, FieldChange, MovedElements, Movement, Renumbering, Shift, ValueChange,
};
pub use program::{CodeChange, CodeKind, ProgramChange, VariableChange};
pub use text::{Hunk, HunkLine, LineKind, TextChange};

use crate::exclusions::Tolerance;

/// Differences between two trees.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Comparison {
    /// Name of the old tree, set by the caller: a folder or a revision.
    pub old: String,
    /// Name of the new tree.
    pub new: String,
    /// Number of compared applications, libraries and user types.
    pub compared: usize,
    /// Applications, libraries and user types with differences, sorted by path.
    pub applications: Vec<ApplicationChange>,
    /// Configuration files of the controller with differences.
    pub settings: Vec<SettingsChange>,
    /// Other kinds of files that differ, sorted by path: recipes, add-ons, pages, logs.
    pub others: Vec<OtherChange>,
    /// Differences that were omitted on request.
    pub ignored: Ignored,
    /// Files that could not be compared as VAL 3.
    pub problems: Vec<Problem>,
}

impl Comparison {
    /// Whether there is no difference.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.applications.is_empty() && self.settings.is_empty() && self.others.is_empty()
    }
}

/// A file of `usr/configs` with differences.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SettingsChange {
    /// Path of the file.
    pub path: String,
    /// Change of the file.
    pub change: Change,
    /// Whether the file describes inputs and outputs.
    pub is_io: bool,
    /// Entries that differ, in file order; empty if the whole file was added or removed.
    pub entries: Vec<EntryChange>,
    /// Difference as text, if a version is no XML.
    pub text: Option<TextChange>,
}

/// Another kind of file that differs. Only its bytes are compared.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct OtherChange {
    /// Path of the file.
    pub path: String,
    /// Change of the file.
    pub change: Change,
}

/// An entry of a configuration file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct EntryChange {
    /// Enclosing elements and attribute name, for example `bioDin[3] name`.
    pub entry: String,
    /// Old value; `None` if the entry did not exist.
    pub old: Option<String>,
    /// New value; `None` if the entry does not exist.
    pub new: Option<String>,
}

/// One of the two trees.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum TreeSide {
    /// The old tree.
    Old,
    /// The new tree.
    New,
}

/// Exclusions and the number of differences omitted for each. They do not affect the exit code.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Ignored {
    /// Tolerance of positions.
    pub tolerance: Option<Tolerance>,
    /// Number of positions within the tolerance.
    pub within_tolerance: usize,
    /// Patterns of data names.
    pub patterns: Vec<String>,
    /// Number of data whose names match a pattern.
    pub data: usize,
    /// Number of positions that moved with a frame or tool whose name matches a pattern.
    pub moved_along: usize,
    /// Number of programs whose layout differences were ignored.
    pub layouts: usize,
}

/// A reason why something could not be compared as VAL 3.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Problem {
    /// Path of the file or folder.
    pub path: String,
    /// Tree with the problem.
    pub side: TreeSide,
    /// Message: the fault, the action taken instead, and the remedy.
    pub message: String,
}
