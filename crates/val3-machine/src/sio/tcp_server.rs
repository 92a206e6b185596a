//! Server socket.
//!
//! The manual limits the number of connected clients but does not define which client is read. Here the channel
//! communicates with one client at a time: when no bytes are unread, it reads from any client that has sent bytes. It
//! writes to the client it has read from last, at first to the client that called first.

use std::net::{SocketAddr, TcpListener};

use super::stream::Stream;
use super::{ByteStream, Connection, LineKind, LineSetting, NetworkAccess, Received, SendResult, SettingRefusal};

/// The server's end of TCP connections.
#[derive(Debug)]
pub struct TcpServer {
    address: SocketAddr,
    limit: usize,
    nagle: bool,
    listener: Option<TcpListener>,
    /// Clients, the current client first.
    clients: Vec<Stream>,
}

/// Maximum number of calls accepted in one pass, so that a flood of calls blocks nothing.
const CALLS: usize = 32;

/// Maximum number of disconnected clients with unread bytes.
const LEFT: usize = 16;

impl TcpServer {
    /// Server for one client at `address`, which can be called from the first read or write on (3.7.1). Port 0 selects
    /// a free port.
    #[must_use]
    pub fn new(address: SocketAddr, access: NetworkAccess) -> Self {
        Self { address: access.address(address), limit: 1, nagle: true, listener: None, clients: Vec::new() }
    }

    /// Address of the server; `None` before the first read or write, or if the port is in use.
    #[must_use]
    pub fn local_address(&self) -> Option<SocketAddr> {
        self.listener.as_ref().and_then(|listener| listener.local_addr().ok())
    }

    fn listen(&mut self) {
        if self.listener.is_none() {
            let listener = TcpListener::bind(self.address);
            self.listener = listener.ok().filter(|listener| listener.set_nonblocking(true).is_ok());
        }
    }

    /// Reads from all clients. Clients after the first that have disconnected without unread bytes are dropped.
    fn hear(&mut self) {
        self.clients.iter_mut().for_each(Stream::listen);
        let mut first = true;
        self.clients.retain(|client| std::mem::take(&mut first) || !client.is_gone() || client.has_input());
    }

    /// Accepts the pending calls; calls above the limit are ended immediately.
    fn accept(&mut self) {
        for _ in 0..CALLS {
            let Some(Ok((tcp, _))) = self.listener.as_ref().map(TcpListener::accept) else { return };
            let gone = self.clients.iter().filter(|client| client.is_gone()).count();
            if self.clients.len() - gone < self.limit && gone < LEFT {
                self.clients.extend(Stream::new(tcp, self.nagle));
                // A client that has connected, sent and disconnected frees its slot for the next client.
                self.hear();
            }
        }
    }

    fn is_connected(&self) -> bool {
        self.clients.iter().any(|client| !client.is_gone())
    }

    /// Selects the first client with unread bytes.
    fn turn(&mut self) {
        if let Some(at) = self.clients.iter().position(Stream::has_input) {
            let client = self.clients.remove(at);
            self.clients.insert(0, client);
        }
    }
}

impl ByteStream for TcpServer {
    fn kind(&self) -> LineKind {
        LineKind::Server
    }

    fn open(&mut self) -> Connection {
        self.listen();
        self.hear();
        self.accept();
        if self.is_connected() { Connection::Open } else { Connection::Closed }
    }

    fn receive(&mut self, room: usize, fresh: bool) -> Received {
        self.hear();
        if fresh && self.clients.first().is_some_and(|first| !first.has_input() && !first.is_gone()) {
            self.turn();
        }
        match self.clients.first_mut() {
            Some(first) if first.has_input() => Received::Bytes(first.take(room)),
            Some(first) if first.is_gone() => {
                self.clients.remove(0);
                Received::Ended
            }
            _ => Received::Nothing,
        }
    }

    fn send(&mut self, bytes: &[u8]) -> SendResult {
        self.clients.first_mut().map_or(SendResult::Lost, |client| client.send(bytes))
    }

    /// The port stays open: the next client is accepted at the next read or write.
    fn close(&mut self) -> bool {
        let connected = self.is_connected();
        self.clients.clear();
        connected
    }

    fn shut_down(&mut self) {
        self.clients.clear();
        self.listener = None;
    }

    fn apply(&mut self, setting: &LineSetting) -> Result<(), SettingRefusal> {
        match setting {
            LineSetting::Nagle(on) => {
                self.nagle = *on;
                self.clients.iter_mut().for_each(|client| client.set_nagle(*on));
            }
            LineSetting::Port(_) | LineSetting::Clients(_) if self.is_connected() => return Err(SettingRefusal::Busy),
            LineSetting::Port(port) => {
                self.address.set_port(*port);
                self.shut_down();
            }
            LineSetting::Clients(clients) => self.limit = usize::from(*clients),
            _ => return Err(SettingRefusal::Value),
        }
        Ok(())
    }
}
