//! The file `usr/applicom/Modbus/modbus.xml`: topics with their items.
//!
//! The form is known from files of public cells only. A topic has a table of bits and one of words:
//!
//! ```xml
//! <TOPIC Name="Modbus" Card="0" Channel="0" Equipment="0" RefreshPeriod="200" Actif="1">
//!   <MODULE Tag_name_root="Bit" IDModule="BOOLEAN" InputSize="" OutputSize="9">
//!     <ITEM Name="bStart" Syntaxe="%Q0" Offset="0"/>
//!     <ITEM Name="bOut" Syntaxe="%I1:8" Offset="1"/>
//! ```

mod addresses;
mod fault;
mod item;
mod reader;

pub use fault::{FaultKind, FileFault};

use crate::{TableKind, Writer};

/// Content of the file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ModbusFile {
    /// Topics in the order of the file.
    pub topics: Vec<Topic>,
    /// Faults, by offset.
    pub faults: Vec<FileFault>,
}

/// Two tables of addresses at one port.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Topic {
    /// Name, which may contain blanks.
    pub name: String,
    /// Whether the controller serves the topic.
    pub is_active: bool,
    /// Items in the order of the file.
    pub items: Vec<Item>,
    /// Maximum number of clients; `None` if the file does not contain it.
    pub clients: Option<u16>,
    /// TCP port; `None` if the file does not contain it.
    pub port: Option<u16>,
    /// Byte offset of the element.
    pub offset: usize,
}

/// A value, or an array of values, at consecutive addresses.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Item {
    /// Name in links.
    pub name: String,
    /// Table of the addresses.
    pub table: TableKind,
    /// Side that writes the values.
    pub writer: Writer,
    /// First address, from 0.
    pub first: u16,
    /// Array size in addresses, 1 to 65536; `None` for a single value.
    pub count: Option<u32>,
    /// Byte offset of the element.
    pub offset: usize,
}

impl ModbusFile {
    /// Reads a file.
    #[must_use]
    pub fn read(text: &str) -> Self {
        let mut file = reader::read(text);
        let faults: Vec<FileFault> = file.topics.iter().flat_map(addresses::faults).collect();
        file.faults.extend(faults);
        file.faults.sort_by_key(|fault| fault.offset);
        file
    }

    /// Whether the file determines the names and types of all items.
    #[must_use]
    pub fn has_all_items(&self) -> bool {
        !self.faults.iter().any(|fault| fault.kind.hides_items())
    }
}

impl Item {
    /// Number of addresses.
    #[must_use]
    pub fn addresses(&self) -> u32 {
        self.count.unwrap_or(1)
    }

    /// Address after the last one.
    fn end(&self) -> u32 {
        u32::from(self.first) + self.addresses()
    }
}

#[cfg(test)]
mod tests;
