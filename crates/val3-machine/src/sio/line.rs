//! The port: one end of a byte stream that leaves the controller.

use serde::{Deserialize, Serialize};

use super::Setting;

/// The kind of a line; each has parameters of its own (3.7.3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LineKind {
    /// A serial line. It is always open.
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
    /// They can.
    Open,
    /// A server was called and has not answered yet.
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
    /// The peer has gone; what comes next is from another one.
    Ended,
}

/// The result of sending.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SendResult {
    /// This number of bytes; fewer than given, or none, if the other end does not take more for now.
    Taken(usize),
    /// The connection has failed.
    Lost,
}

/// Why a line does not take a setting.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SettingRefusal {
    /// It cannot do that.
    Value,
    /// Not while it is connected.
    Busy,
}

/// One end of a byte stream. No method waits, and none takes or keeps more than it is asked for.
pub trait ByteStream {
    /// Its kind, which never changes.
    fn kind(&self) -> LineKind;

    /// Opens the line where it is closed, if possible now, and accepts callers.
    fn open(&mut self) -> Connection;

    /// Takes at most `room` bytes that have come in. `fresh` says that nothing received before is left unread: only
    /// then may another peer be heard.
    fn receive(&mut self, room: usize, fresh: bool) -> Received;

    /// Sends as many of the bytes as the other end takes now.
    fn send(&mut self, bytes: &[u8]) -> SendResult;

    /// Ends the connection; `false` if there was none.
    fn close(&mut self) -> bool;

    /// Stops completely, as at the end of the application: no peer can connect any more.
    fn shut_down(&mut self);

    /// Changes a parameter of the line.
    ///
    /// # Errors
    /// If the line cannot, or not now.
    fn apply(&mut self, setting: &Setting) -> Result<(), SettingRefusal>;
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

    fn apply(&mut self, setting: &Setting) -> Result<(), SettingRefusal> {
        (**self).apply(setting)
    }
}
