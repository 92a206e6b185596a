//! Changes of the tables of a data file, as plain data.

use val3_lang::types::Container;

use crate::data_tables::{DataPlace, DataProblem};

/// A change of the tables of a data file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DataEdit {
    /// Gives cells other texts.
    Set(Vec<CellEdit>),
    /// Declares a variable.
    Add(NewDatum),
    /// Declares a variable with the type and the values of another one, after it.
    Duplicate {
        /// The variable to copy.
        name: String,
        /// The name of the copy.
        new_name: String,
    },
    /// Takes out variables. Programs and fathers may use them.
    Delete(Vec<String>),
    /// Lets other projects use variables, or not.
    Access {
        /// The variables.
        names: Vec<String>,
        /// Other projects may use them.
        public: bool,
    },
    /// Gives an array other sizes. Values beyond them go.
    Resize {
        /// The variable, or a field.
        place: DataPlace,
        /// The sizes of all dimensions.
        sizes: Vec<u32>,
    },
    /// Adds an element to a collection.
    AddKey {
        /// The collection.
        place: DataPlace,
        /// The new key.
        key: String,
    },
    /// Takes elements out of a collection.
    RemoveKeys {
        /// The collection.
        place: DataPlace,
        /// The keys.
        keys: Vec<String>,
    },
    /// Gives an element of a collection another key. Programs that use the old one stay.
    RenameKey {
        /// The collection.
        place: DataPlace,
        /// The key.
        key: String,
        /// The new key.
        new_key: String,
    },
}

/// The new text of a cell.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CellEdit {
    /// The value.
    pub place: DataPlace,
    /// The column, by its id.
    pub column: String,
    /// The text; `None` for the default.
    pub text: Option<String>,
}

/// A variable to declare.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NewDatum {
    /// The name.
    pub name: String,
    /// The type, as files spell it.
    pub type_name: String,
    /// Other projects may use it.
    pub public: bool,
    /// An array or a collection.
    pub container: Container,
    /// The sizes of an array; none for a collection.
    pub sizes: Vec<u32>,
    /// The variable that precedes it. Without it, or if there is none with this name, it comes after the last one.
    pub after: Option<String>,
}

/// The reason why a change is impossible.
pub(super) fn refusal(reason: impl Into<String>) -> DataProblem {
    DataProblem { reason: reason.into(), range: None }
}
