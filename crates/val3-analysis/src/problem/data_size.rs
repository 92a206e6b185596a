//! Memory of a variable.

use smol_str::SmolStr;

/// A variable and its memory.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct DataSize {
    /// Variable name.
    pub name: SmolStr,
    /// Size of the variable in bytes.
    pub bytes: u64,
    /// Size of this and all preceding variables of the file in bytes.
    pub total: u64,
}
