//! The memory that a variable needs.

use smol_str::SmolStr;

/// A variable and the bytes that it needs.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct DataSize {
    /// The variable.
    pub name: SmolStr,
    /// Bytes of the variable.
    pub bytes: u64,
    /// Bytes of the variable and those before it in the file.
    pub total: u64,
}
