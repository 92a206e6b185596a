//! Serial lines and sockets (3.7): what a program reads and writes through a `sio` variable.
//!
//! A [`Channel`] is what the variable is linked to: end of string, timeout and what has come in. Behind it a [`ByteStream`]
//! moves bytes and never waits: an instruction that has to wait gets [`Attempt::Wait`] and asks again at its next turn.

mod channel;
mod configuration;
mod guarded;
mod line;
mod memory;
mod network_access;
mod recording;
mod scripted;
#[cfg(unix)]
mod serial;
mod setting;
mod stream;
mod tcp_client;
mod tcp_server;
mod udp;

pub use channel::{Attempt, Channel, ChannelState, Sending, SioFault, byte_of};
pub use configuration::{ChannelConfig, channels};
pub use guarded::{SocketGuard, SocketRequest};
pub use line::{ByteStream, Connection, LineKind, Received, SendResult, SettingRefusal};
pub use memory::{MemoryLine, Peer};
pub use network_access::NetworkAccess;
pub use recording::{Entry, LineAnswer, Recorder, RecorderState, Replay, replay};
pub use scripted::{ScriptedLine, ScriptedPeer};
#[cfg(unix)]
pub use serial::SerialLine;
pub use setting::{Parity, Setting, SettingValue};
pub use tcp_client::TcpClient;
pub use tcp_server::TcpServer;
pub use udp::UdpLine;

#[cfg(test)]
mod tests;
