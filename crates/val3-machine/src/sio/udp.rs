//! UDP socket. It sends to its target, or without a target to the last sender.

use std::io::ErrorKind;
use std::net::{SocketAddr, UdpSocket};

use super::{ByteStream, Connection, LineKind, LineSetting, NetworkAccess, Received, SendResult, SettingRefusal};

/// UDP socket. The manual does not describe it; controllers have it since s8.
#[derive(Debug)]
pub struct UdpLine {
    local: SocketAddr,
    target: Option<SocketAddr>,
    heard: Option<SocketAddr>,
    access: NetworkAccess,
    socket: Option<UdpSocket>,
}

/// Maximum size of a datagram, in bytes.
const LONGEST: usize = 65_507;

impl UdpLine {
    /// Receives at `local` and sends to `target` from the first read or write on. Port 0 selects a free port.
    #[must_use]
    pub fn new(local: SocketAddr, target: Option<SocketAddr>, access: NetworkAccess) -> Self {
        Self { local: access.address(local), target, heard: None, access, socket: None }
    }

    /// Local address; `None` before the first read or write, or if the port is in use.
    #[must_use]
    pub fn local_address(&self) -> Option<SocketAddr> {
        self.socket.as_ref().and_then(|socket| socket.local_addr().ok())
    }
}

impl ByteStream for UdpLine {
    fn kind(&self) -> LineKind {
        LineKind::Udp
    }

    fn open(&mut self) -> Connection {
        if self.socket.is_none() {
            let socket = UdpSocket::bind(self.local);
            self.socket = socket.ok().filter(|socket| socket.set_nonblocking(true).is_ok());
        }
        if self.socket.is_some() { Connection::Open } else { Connection::Closed }
    }

    /// A datagram stays in the system's buffer until there is room for the longest datagram; the system drops floods.
    fn receive(&mut self, room: usize, _fresh: bool) -> Received {
        let Some(socket) = self.socket.as_ref().filter(|_| room >= LONGEST) else { return Received::Nothing };
        let mut datagram = vec![0; LONGEST];
        match socket.recv_from(&mut datagram) {
            Ok((count, from)) => {
                self.heard = Some(from);
                datagram.truncate(count);
                Received::Bytes(datagram)
            }
            Err(_) => Received::Nothing,
        }
    }

    fn send(&mut self, bytes: &[u8]) -> SendResult {
        let (Some(socket), Some(target)) = (&self.socket, self.target.or(self.heard)) else {
            return SendResult::Taken(0);
        };
        let (datagram, _) = bytes.split_at(bytes.len().min(LONGEST));
        match socket.send_to(datagram, self.access.address(target)) {
            Ok(count) => SendResult::Taken(count),
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted) => {
                SendResult::Taken(0)
            }
            // The error belongs to an earlier datagram that was rejected: this datagram was not sent.
            Err(error) if error.kind() == ErrorKind::ConnectionRefused => SendResult::Taken(0),
            Err(_) => SendResult::Lost,
        }
    }

    /// UDP needs no connection: the last sender stays the target, so that a program that clears its buffer in each
    /// cycle can still reply.
    fn close(&mut self) -> bool {
        self.socket.take().is_some()
    }

    fn shut_down(&mut self) {
        self.close();
        self.heard = None;
    }

    fn apply(&mut self, setting: &LineSetting) -> Result<(), SettingRefusal> {
        if self.socket.is_some() {
            return Err(SettingRefusal::Busy);
        }
        // The manual has one port for a channel; here it applies to both ends.
        match setting {
            LineSetting::Port(port) => {
                self.local.set_port(*port);
                self.target.iter_mut().for_each(|target| target.set_port(*port));
            }
            LineSetting::Target(address) => self.target = Some(SocketAddr::new(*address, self.local.port())),
            _ => return Err(SettingRefusal::Value),
        }
        Ok(())
    }
}
