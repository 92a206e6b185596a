//! Serial lines and sockets (3.7), which programs access through `sio` variables.
//!
//! A variable is linked to a [`Channel`]: end of string, timeout and received bytes. Its [`ByteStream`] transfers bytes
//! and never waits: a waiting instruction receives [`Attempt::Wait`] and calls again in its next turn.

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

pub use channel::{Attempt, Channel, ChannelState, Sending, SioFault, UnfinishedString, byte_of};
pub use configuration::{ChannelConfig, channels};
pub use guarded::{SocketGuard, SocketRequest};
pub use line::{ByteStream, Connection, LineKind, Received, SendResult, SettingRefusal};
pub use memory::{MemoryLine, Peer};
pub use network_access::NetworkAccess;
pub use recording::{LineAnswer, LineRecorder, RecordedReply, RecorderState, Replay, replay};
pub use scripted::{ScriptedLine, ScriptedPeer};
#[cfg(unix)]
pub use serial::SerialLine;
pub use setting::{LineSetting, Parity, SettingValue};
pub use tcp_client::TcpClient;
pub use tcp_server::TcpServer;
pub use udp::UdpLine;

#[cfg(test)]
mod tests;
