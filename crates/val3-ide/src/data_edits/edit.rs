//! Table edits in a data file, as plain data.

use val3_lang::types::Container;

use crate::data_tables::{DataPlace, DataProblem};

/// An edit of a data file's tables.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DataEdit {
    /// Sets the texts of cells.
    Set(Vec<CellEdit>),
    /// Declares a variable.
    Add(NewDatum),
    /// Declares a copy of a variable, after the original.
    Duplicate {
        /// Variable to copy.
        name: String,
        /// Name of the copy.
        new_name: String,
    },
    /// Removes variables. Programs and father references may still use them.
    Delete(Vec<String>),
    /// Changes the access of variables.
    Access {
        /// Variables.
        names: Vec<String>,
        /// Whether other projects may use them.
        public: bool,
    },
    /// Changes array sizes. Values outside the new sizes are removed.
    Resize {
        /// The variable, or a field.
        place: DataPlace,
        /// Sizes of all dimensions.
        sizes: Vec<u32>,
    },
    /// Adds an element to a collection.
    AddKey {
        /// The collection.
        place: DataPlace,
        /// New key.
        key: String,
    },
    /// Removes elements from a collection.
    RemoveKeys {
        /// The collection.
        place: DataPlace,
        /// Keys.
        keys: Vec<String>,
    },
    /// Renames a key of a collection. Programs that use the old key are unchanged.
    RenameKey {
        /// The collection.
        place: DataPlace,
        /// Old key.
        key: String,
        /// New key.
        new_key: String,
    },
}

/// New text of a cell.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CellEdit {
    /// The value.
    pub place: DataPlace,
    /// Column id.
    pub column: String,
    /// Text; `None` for the default.
    pub text: Option<String>,
}

/// A new variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NewDatum {
    /// Name.
    pub name: String,
    /// Type name as spelled in files.
    pub type_name: String,
    /// Whether other projects may use it.
    pub public: bool,
    /// Array or collection.
    pub container: Container,
    /// Array sizes; empty for a collection.
    pub sizes: Vec<u32>,
    /// Preceding variable. If it is `None` or does not exist, the new variable is appended.
    pub after: Option<String>,
}

/// Creates the reason why an edit is impossible.
pub(super) fn refusal(reason: impl Into<String>) -> DataProblem {
    DataProblem { reason: reason.into(), range: None }
}
