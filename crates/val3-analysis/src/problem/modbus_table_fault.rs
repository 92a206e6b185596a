//! A fault of the tables of the cell's Modbus server.

use smol_str::SmolStr;

/// Fault of a line of `modbus.xml`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModbusTableFault {
    /// Path of the file below `usr`.
    pub path: SmolStr,
    /// Line, from 1.
    pub line: usize,
    /// What is wrong, in English.
    pub description: SmolStr,
    /// Whether the links of items are unknown, so that links to the server are not checked.
    pub hides_items: bool,
}
