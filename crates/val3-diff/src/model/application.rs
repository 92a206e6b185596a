//! Differences of one application, library or user type.

use serde::Serialize;

use super::EntryChange;
use super::change::Change;
use super::data::DataChange;
use super::program::ProgramChange;
use super::text::TextChange;

/// The differences of one project: an application, a library or a user type.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ApplicationChange {
    /// The name: that of the `.pjx` without its extension.
    pub name: String,
    /// The path of the `.pjx`, or of the folder with files that belong to no project.
    pub path: String,
    /// What happened to the project as a whole. All items of an added project are added.
    pub change: Change,
    /// The path in the old tree, if it was another one.
    pub moved_from: Option<String>,
    /// Parameters of the project file: version, stack size, unit.
    pub project: Vec<ProjectChange>,
    /// Library identifiers.
    pub libraries: Vec<ReferenceChange>,
    /// User types.
    pub types: Vec<ReferenceChange>,
    /// Programs, by name.
    pub programs: Vec<ProgramChange>,
    /// Global data, by name. For a user type these are its fields.
    pub data: Vec<DataChange>,
    /// Public items that differ, if other projects use this one or it has no `start`.
    pub interface: Vec<InterfaceChange>,
    /// The projects that load this one as a library or use it as a type.
    pub used_by: Vec<String>,
    /// Broken files, compared as text.
    pub texts: Vec<TextChange>,
    /// Files that differ in something that belongs to no item above, such as an unknown attribute.
    pub contents: Vec<ContentChange>,
}

/// A VAL 3 file that differs in its XML.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ContentChange {
    /// The path.
    pub path: String,
    /// The attributes and texts that differ.
    pub entries: Vec<EntryChange>,
}

impl ApplicationChange {
    /// Nothing in it differs.
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
    /// The name of the parameter in the file.
    pub name: String,
    /// The old value; `None` if it was not written.
    pub old: Option<String>,
    /// The new value; `None` if it is not written.
    pub new: Option<String>,
}

/// A library identifier or a user type of a project file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ReferenceChange {
    /// The identifier, or the name of the type.
    pub name: String,
    /// What happened to it.
    pub change: Change,
    /// The old path; `None` if it was added.
    pub old: Option<String>,
    /// The new path; `None` if it was removed.
    pub new: Option<String>,
}

/// The kind of a public item.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ItemKind {
    /// A program.
    Program,
    /// Global data.
    Data,
}

/// A public item that other projects see in another way.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct InterfaceChange {
    /// Program or data.
    pub kind: ItemKind,
    /// The name.
    pub name: String,
    /// What happened to it as a public item.
    pub change: Change,
    /// The old parameters or type; `None` if it was not public.
    pub old: Option<String>,
    /// The new parameters or type; `None` if it is not public.
    pub new: Option<String>,
    /// Programs that use it may no longer compile.
    pub breaks_users: bool,
}
