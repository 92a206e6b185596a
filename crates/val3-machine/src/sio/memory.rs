//! Line whose other end is in the same process: for tests, and for input that is set by hand.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

use super::{ByteStream, Connection, LineKind, LineSetting, Received, SendResult, SettingRefusal};

/// Controller's end of the line.
#[derive(Debug)]
pub struct MemoryLine {
    kind: LineKind,
    wire: Rc<RefCell<Wire>>,
}

/// Other end of the line.
#[derive(Debug, Clone)]
pub struct Peer {
    wire: Rc<RefCell<Wire>>,
}

#[derive(Debug, Default)]
struct Wire {
    connected: bool,
    /// Whether the peer has disconnected and the line has not reported it.
    ended: bool,
    to_line: VecDeque<u8>,
    to_peer: Vec<u8>,
    /// Number of bytes that the peer still accepts.
    window: Option<usize>,
    settings: Vec<LineSetting>,
}

impl MemoryLine {
    /// Creates both ends; no peer is connected.
    #[must_use]
    pub fn pair(kind: LineKind) -> (Self, Peer) {
        let wire = Rc::new(RefCell::new(Wire::default()));
        (Self { kind, wire: Rc::clone(&wire) }, Peer { wire })
    }
}

impl ByteStream for MemoryLine {
    fn kind(&self) -> LineKind {
        self.kind
    }

    fn open(&mut self) -> Connection {
        let open = self.wire.borrow().connected || self.kind == LineKind::Serial;
        if open { Connection::Open } else { Connection::Closed }
    }

    fn receive(&mut self, room: usize, _fresh: bool) -> Received {
        let mut wire = self.wire.borrow_mut();
        let count = room.min(wire.to_line.len());
        if count > 0 {
            return Received::Bytes(wire.to_line.drain(..count).collect());
        }
        if std::mem::take(&mut wire.ended) { Received::Ended } else { Received::Nothing }
    }

    fn send(&mut self, bytes: &[u8]) -> SendResult {
        let mut wire = self.wire.borrow_mut();
        if !wire.connected && self.kind != LineKind::Serial {
            return SendResult::Lost;
        }
        let count = bytes.len().min(wire.window.unwrap_or(usize::MAX));
        wire.window = wire.window.map(|window| window - count);
        wire.to_peer.extend(bytes.iter().take(count));
        SendResult::Taken(count)
    }

    fn close(&mut self) -> bool {
        let mut wire = self.wire.borrow_mut();
        wire.to_line.clear();
        wire.ended = false;
        std::mem::take(&mut wire.connected)
    }

    fn shut_down(&mut self) {
        self.close();
    }

    fn apply(&mut self, setting: &LineSetting) -> Result<(), SettingRefusal> {
        let mut wire = self.wire.borrow_mut();
        if wire.connected && matches!(setting, LineSetting::Port(_) | LineSetting::Target(_) | LineSetting::Clients(_))
        {
            return Err(SettingRefusal::Busy);
        }
        wire.settings.push(*setting);
        Ok(())
    }
}

impl Peer {
    /// Connects.
    pub fn connect(&self) {
        self.wire.borrow_mut().connected = true;
    }

    /// Ends the connection; bytes sent before still arrive.
    pub fn disconnect(&self) {
        let mut wire = self.wire.borrow_mut();
        wire.connected = false;
        wire.ended = true;
    }

    /// Sends bytes to the controller.
    pub fn send(&self, bytes: impl AsRef<[u8]>) {
        self.wire.borrow_mut().to_line.extend(bytes.as_ref());
    }

    /// Removes and returns the bytes that the controller has sent.
    #[must_use]
    pub fn take(&self) -> Vec<u8> {
        std::mem::take(&mut self.wire.borrow_mut().to_peer)
    }

    /// Accepts only this number of further bytes from the controller.
    pub fn stall_after(&self, bytes: usize) {
        self.wire.borrow_mut().window = Some(bytes);
    }

    /// The parameters that the controller has set.
    #[must_use]
    pub fn settings(&self) -> Vec<LineSetting> {
        self.wire.borrow().settings.clone()
    }

    /// Whether the connection is open.
    #[must_use]
    pub fn is_connected(&self) -> bool {
        self.wire.borrow().connected
    }
}
