//! The port: one end of a byte stream from the controller to the outside.

use serde::{Deserialize, Serialize};

use super::LineSetting;

/// Kind of a line, which determines its parameters (3.7.3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LineKind {
    /// Serial line, which is always open.
    Serial,
    /// A socket that calls a server.
    Client,
    /// A socket that is called by clients.
    Server,
    /// A socket for datagrams.
    Udp,
}

/// Whether bytes can pass.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Connection {
    /// Bytes can pass.
    Open,
    /// A server was called and has not accepted yet.
    Calling,
    /// No peer is connected.
    Closed,
}

/// Received input.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Received {
    /// Nothing for now.
    Nothing,
    /// These bytes.
    Bytes(Vec<u8>),
    /// The peer has disconnected; later bytes are from a new peer.
    Ended,
}

/// The result of sending.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SendResult {
    /// Number of sent bytes, which is below the number of passed bytes or 0 if the other end accepts no more for now.
    Taken(usize),
    /// The connection has failed.
    Lost,
}

/// Reason why a line rejects a setting.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SettingRefusal {
    /// The line does not support the value.
    Value,
    /// The setting cannot change while the line is connected.
    Busy,
}

/// One end of a byte stream. No method waits, and no method reads or stores more bytes than requested.
pub trait ByteStream {
    /// Returns the kind, which never changes.
    fn kind(&self) -> LineKind;

    /// Opens the line if it is closed and can be opened now, and accepts callers.
    fn open(&mut self) -> Connection;

    /// Reads at most `room` received bytes. `fresh` is set if all bytes received before were read: only then may
    /// another peer be read.
    fn receive(&mut self, room: usize, fresh: bool) -> Received;

    /// Sends as many bytes as the other end accepts now.
    fn send(&mut self, bytes: &[u8]) -> SendResult;

    /// Ends the connection; returns `false` if the line was not connected.
    fn close(&mut self) -> bool;

    /// Stops completely, as at the end of the application: no peer can connect any more.
    fn shut_down(&mut self);

    /// Changes a parameter of the line.
    ///
    /// # Errors
    /// If the line does not support the value, or cannot change it while it is connected.
    fn apply(&mut self, setting: &LineSetting) -> Result<(), SettingRefusal>;
}

impl<L: ByteStream + ?Sized> ByteStream for Box<L> {
    fn kind(&self) -> LineKind {
        (**self).kind()
    }

    fn open(&mut self) -> Connection {
        (**self).open()
    }

    fn receive(&mut self, room: usize, fresh: bool) -> Received {
        (**self).receive(room, fresh)
    }

    fn send(&mut self, bytes: &[u8]) -> SendResult {
        (**self).send(bytes)
    }

    fn close(&mut self) -> bool {
        (**self).close()
    }

    fn shut_down(&mut self) {
        (**self).shut_down();
    }

    fn apply(&mut self, setting: &LineSetting) -> Result<(), SettingRefusal> {
        (**self).apply(setting)
    }
}
