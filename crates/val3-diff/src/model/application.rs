//! Differences in an application, library or user type.

use serde::Serialize;

use super::EntryChange;
use super::change::Change;
use super::data::DataChange;
use super::program::ProgramChange;
use super::text::TextChange;

/// Differences in a project: an application, a library or a user type.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ApplicationChange {
    /// Name of the `.pjx` without its extension.
    pub name: String,
    /// Path of the `.pjx`, or of the folder for files that belong to no project.
    pub path: String,
    /// Change of the entire project. If the project was added, all items are added.
    pub change: Change,
    /// Path in the old tree, if it differs.
    pub moved_from: Option<String>,
    /// Parameters of the project file: version, stack size, unit.
    pub project: Vec<ProjectChange>,
    /// Library identifiers.
    pub libraries: Vec<ReferenceChange>,
    /// User types.
    pub types: Vec<ReferenceChange>,
    /// Programs, sorted by name.
    pub programs: Vec<ProgramChange>,
    /// Global data, sorted by name; for a user type, its fields.
    pub data: Vec<DataChange>,
    /// Public items that differ, if other projects use this project or it has no `start`.
    pub interface: Vec<InterfaceChange>,
    /// Projects that use this project as a library or type.
    pub used_by: Vec<String>,
    /// Broken files, compared as text.
    pub texts: Vec<TextChange>,
    /// Files with differences that belong to no item above, such as an unknown attribute.
    pub contents: Vec<ContentChange>,
}

/// A VAL 3 file with differences in its XML.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ContentChange {
    /// Path of the file.
    pub path: String,
    /// Attributes and texts that differ.
    pub entries: Vec<EntryChange>,
}

impl ApplicationChange {
    /// Whether there is no difference.
    pub(crate) fn is_empty(&self) -> bool {
        self.change == Change::Changed
            && self.moved_from.is_none()
            && self.project.is_empty()
            && self.libraries.is_empty()
            && self.types.is_empty()
            && self.programs.is_empty()
            && self.data.is_empty()
            && self.interface.is_empty()
            && self.texts.is_empty()
            && self.contents.is_empty()
    }
}

/// A parameter of a project file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ProjectChange {
    /// Parameter name in the file.
    pub name: String,
    /// Old value; `None` if it was not written.
    pub old: Option<String>,
    /// New value; `None` if it is not written.
    pub new: Option<String>,
}

/// A library identifier or a user type in a project file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ReferenceChange {
    /// Identifier, or name of the type.
    pub name: String,
    /// Change of the entry.
    pub change: Change,
    /// Old path; `None` if the entry was added.
    pub old: Option<String>,
    /// New path; `None` if the entry was removed.
    pub new: Option<String>,
}

/// Kind of a public item.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ItemKind {
    /// A program.
    Program,
    /// Global data.
    Data,
}

/// A public item whose interface differs.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct InterfaceChange {
    /// Program or data.
    pub kind: ItemKind,
    /// Item name.
    pub name: String,
    /// Change of the public item.
    pub change: Change,
    /// Old parameters or type; `None` if the item was not public.
    pub old: Option<String>,
    /// New parameters or type; `None` if the item is not public.
    pub new: Option<String>,
    /// Whether programs that use the item may no longer compile.
    pub breaks_users: bool,
}
