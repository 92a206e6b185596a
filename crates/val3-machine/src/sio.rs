//! Serial lines and sockets (3.7): what a program reads and writes through a `sio` variable.
//!
//! A [`Channel`] is what the variable is linked to: end of string, timeout and what has come in. Behind it a [`Line`]
//! moves bytes and never waits: an instruction that has to wait gets [`Turn::Wait`] and asks again at its next turn.

mod channel;
mod line;
mod memory;
mod setting;

pub use channel::{Channel, Sending, SioFault, Turn, byte_of};
pub use line::{Connection, Line, LineKind, Received, Refused, Sent};
pub use memory::{MemoryLine, Peer};
pub use setting::{Parity, Setting, SettingValue};
