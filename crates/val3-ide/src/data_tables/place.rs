//! Places in the tables of a data file.

/// A value in a data file, or a variable.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default, PartialOrd, Ord)]
pub struct DataPlace {
    /// Variable name; empty for a place outside all variables.
    pub name: String,
    /// Key of the value; `None` for the variable itself.
    pub key: Option<String>,
    /// Path from the value to a nested value in its fields.
    pub within: Vec<FieldStep>,
}

/// A field of a user type's value.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FieldStep {
    /// Field name.
    pub name: String,
    /// Key of the field's value; empty for the field itself.
    pub key: String,
}

/// Parses a path such as `tSlots[1,2].pPlace[0]`, whose keys have no quotes.
pub(crate) fn place_of_path(path: &str) -> DataPlace {
    // A key of a collection may contain a dot or a bracket.
    let steps = path.split("].").map(|step| step.strip_suffix(']').unwrap_or(step));
    let mut steps = steps.map(|step| step.split_once('[').unwrap_or((step, "")));
    let (name, key) = steps.next().unwrap_or_default();
    let within = steps.map(|(name, key)| FieldStep { name: name.to_owned(), key: key.to_owned() }).collect();
    DataPlace { name: name.to_owned(), key: Some(key.to_owned()), within }
}
