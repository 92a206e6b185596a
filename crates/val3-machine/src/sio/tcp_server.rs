//! A socket that clients call.
//!
//! The manual limits how many clients are connected at a time and leaves open which of them is heard. Here the channel
//! talks with one at a time: it hears any client that has sent something when nothing is left unread, and answers the one it
//! heard last, at first the one that called first.

use std::net::{SocketAddr, TcpListener};

use super::stream::Stream;
use super::{ByteStream, Connection, LineKind, NetworkAccess, Received, SendResult, Setting, SettingRefusal};

/// The server's end of TCP connections.
#[derive(Debug)]
pub struct TcpServer {
    address: SocketAddr,
    limit: usize,
    nagle: bool,
    listener: Option<TcpListener>,
    /// The client it talks with is first.
    clients: Vec<Stream>,
}

/// Calls that are looked at at once, so that a flood of them holds nothing up.
const CALLS: usize = 32;

/// Clients that have gone and left something to read.
const LEFT: usize = 16;

impl TcpServer {
    /// A server for one client at `address`, which can be called from the first read or write on (3.7.1). Port 0
    /// takes a free one.
    #[must_use]
    pub fn new(address: SocketAddr, access: NetworkAccess) -> Self {
        Self { address: access.address(address), limit: 1, nagle: true, listener: None, clients: Vec::new() }
    }

    /// Where it can be called; `None` before the first read or write, or if the port is taken.
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

    /// Reads from all clients. Those after the first that have gone without unread bytes are dropped.
    fn hear(&mut self) {
        self.clients.iter_mut().for_each(Stream::listen);
        let mut first = true;
        self.clients.retain(|client| std::mem::take(&mut first) || !client.is_gone() || client.has_input());
    }

    /// Takes the calls that have come; above the limit they are ended at once.
    fn accept(&mut self) {
        for _ in 0..CALLS {
            let Some(Ok((tcp, _))) = self.listener.as_ref().map(TcpListener::accept) else { return };
            let gone = self.clients.iter().filter(|client| client.is_gone()).count();
            if self.clients.len() - gone < self.limit && gone < LEFT {
                self.clients.extend(Stream::new(tcp, self.nagle));
                // A client that has connected, sent and gone leaves its place to the next one.
                self.hear();
            }
        }
    }

    fn is_connected(&self) -> bool {
        self.clients.iter().any(|client| !client.is_gone())
    }

    /// Turns to the first client that has something to say.
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

    /// The port stays open: the next client is heard at the next read or write.
    fn close(&mut self) -> bool {
        let connected = self.is_connected();
        self.clients.clear();
        connected
    }

    fn shut_down(&mut self) {
        self.clients.clear();
        self.listener = None;
    }

    fn apply(&mut self, setting: &Setting) -> Result<(), SettingRefusal> {
        match setting {
            Setting::Nagle(on) => {
                self.nagle = *on;
                self.clients.iter_mut().for_each(|client| client.set_nagle(*on));
            }
            Setting::Port(_) | Setting::Clients(_) if self.is_connected() => return Err(SettingRefusal::Busy),
            Setting::Port(port) => {
                self.address.set_port(*port);
                self.shut_down();
            }
            Setting::Clients(clients) => self.limit = usize::from(*clients),
            _ => return Err(SettingRefusal::Value),
        }
        Ok(())
    }
}
