//! The Modbus server of a controller, without sockets and without signals.
//!
//! [`ModbusFile`] contains the tables of `usr/applicom/Modbus/modbus.xml`. A [`ModbusMap`] contains one topic's addresses,
//! and a [`ModbusImage`] their values, which the run and the clients exchange. [`Message`] splits received bytes, and
//! [`respond`] executes a request on the image. Requests and responses are encoded by `modbus-core`.

mod element;
pub mod file;
mod image;
mod map;
mod message;
mod request;
mod word;

pub use element::Element;
pub use file::{FileFault, ModbusFile};
pub use image::{ModbusImage, Write};
pub use map::{ModbusMap, NotServed};
pub use message::{Message, NotModbus};
pub use request::respond;
pub use word::word;

/// Device name in the links of data: `ModbusSrv-0\Modbus-Bit\bStart`.
pub const DEVICE: &str = "ModbusSrv-0";

/// Table of addresses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum TableKind {
    /// Bits, for `dio` variables: coils, and the same values as discrete inputs.
    Bits,
    /// Words of 16 bits, for `aio` variables: holding registers, and the same values as input registers.
    Words,
}

impl TableKind {
    /// Both tables.
    pub const ALL: [Self; 2] = [Self::Bits, Self::Words];

    /// Name in links.
    #[must_use]
    pub const fn link_name(self) -> &'static str {
        match self {
            Self::Bits => "Bit",
            Self::Words => "Word",
        }
    }

    /// Letters after `Q` or `I` in an item's `Syntaxe`.
    const fn letters(self) -> &'static str {
        match self {
            Self::Bits => "",
            Self::Words => "W",
        }
    }

    /// Address size in bits.
    const fn bits(self) -> u32 {
        match self {
            Self::Bits => 1,
            Self::Words => 16,
        }
    }
}

/// Side that writes an item's values. The file names each direction as seen by the client.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Writer {
    /// `%Q`: an output of the client, which programs of the robot only read.
    Client,
    /// `%I`: an input of the client, which programs of the robot write.
    Robot,
}
