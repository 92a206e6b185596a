//! What differs between two trees, as plain data. Renderers and other programs read it; nothing in it refers to files.

mod application;
mod change;
mod class;
mod data;
mod ignored;
mod program;
mod text;

use serde::Serialize;

pub use application::{ApplicationChange, ContentChange, InterfaceChange, ItemKind, ProjectChange, ReferenceChange};
pub use change::{Change, Pair};
pub use class::Class;
pub use data::{DataChange, Dependent, Displacement, FieldChange, Movement, Renumbering, Run, Shift, ValueChange};
pub use ignored::Ignored;
pub use program::{CodeChange, CodeKind, ProgramChange, VariableChange};
pub use text::{Hunk, HunkLine, LineKind, TextChange};

/// The differences between two trees.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Comparison {
    /// What the old tree is called: a folder or a revision. The caller names it.
    pub old: String,
    /// What the new tree is called.
    pub new: String,
    /// Number of applications, libraries and user types that were compared.
    pub compared: usize,
    /// Applications, libraries and user types with differences, by path.
    pub applications: Vec<ApplicationChange>,
    /// Files of the controller's configuration with differences.
    pub settings: Vec<SettingsChange>,
    /// Files of other kinds that differ, by path: recipes, add-ons, pages, logs.
    pub others: Vec<OtherChange>,
    /// Differences that were left out on request.
    pub ignored: Ignored,
    /// What could not be compared as VAL 3.
    pub problems: Vec<Problem>,
}

impl Comparison {
    /// Nothing differs.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.applications.is_empty() && self.settings.is_empty() && self.others.is_empty()
    }
}

/// A file of `usr/configs` with differences.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SettingsChange {
    /// Its path.
    pub path: String,
    /// What happened to the file.
    pub change: Change,
    /// The file describes inputs and outputs.
    pub is_io: bool,
    /// Its entries that differ, in the order of the file. Empty if the whole file was added or removed.
    pub entries: Vec<EntryChange>,
    /// The difference as text, if one of the versions is no XML.
    pub text: Option<TextChange>,
}

/// A file of another kind that differs. Only its bytes are compared.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct OtherChange {
    /// Its path.
    pub path: String,
    /// What happened to the file.
    pub change: Change,
}

/// An entry of a file of settings.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct EntryChange {
    /// The elements around it and the name of the attribute: `bioDin[3] name`.
    pub entry: String,
    /// The old value; `None` if there was no such entry.
    pub old: Option<String>,
    /// The new value; `None` if there is no such entry.
    pub new: Option<String>,
}

/// Which of the two trees.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Side {
    /// The old one.
    Old,
    /// The new one.
    New,
}

/// Something that could not be compared as VAL 3.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Problem {
    /// The path of the file or folder.
    pub path: String,
    /// The tree with the problem.
    pub side: Side,
    /// What is wrong, what was done instead, and the remedy.
    pub message: String,
}
