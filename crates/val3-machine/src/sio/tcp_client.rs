//! Client socket. It reconnects after the end of a connection when the program continues.

use std::net::SocketAddr;

use socket2::{Domain, Protocol, Socket, Type};

use super::stream::Stream;
use super::{ByteStream, Connection, LineKind, LineSetting, NetworkAccess, Received, SendResult, SettingRefusal};

/// Client end of a TCP connection.
#[derive(Debug)]
pub struct TcpClient {
    server: SocketAddr,
    access: NetworkAccess,
    nagle: bool,
    state: TcpClientState,
}

#[derive(Debug)]
enum TcpClientState {
    Closed,
    Calling(Socket),
    Open(Stream),
}

impl TcpClient {
    /// Creates a client of `server`, which is called at the first read or write of the program (3.7.1).
    #[must_use]
    pub fn new(server: SocketAddr, access: NetworkAccess) -> Self {
        Self { server, access, nagle: true, state: TcpClientState::Closed }
    }

    /// Starts to call.
    fn call(&self) -> TcpClientState {
        let server = self.access.address(self.server);
        let socket = Socket::new(Domain::for_address(server), Type::STREAM, Some(Protocol::TCP));
        let Ok(socket) = socket.and_then(|socket| socket.set_nonblocking(true).map(|()| socket)) else {
            return TcpClientState::Closed;
        };
        match socket.connect(&server.into()) {
            Err(error) if !is_under_way(&error) => TcpClientState::Closed,
            _ => TcpClientState::Calling(socket),
        }
    }

    /// Checks whether a server has accepted.
    fn answer(&self, socket: Socket) -> TcpClientState {
        match socket.take_error() {
            Ok(None) if socket.peer_addr().is_err() => TcpClientState::Calling(socket),
            Ok(None) if calls_itself(&socket) => TcpClientState::Closed,
            Ok(None) => Stream::new(socket.into(), self.nagle).map_or(TcpClientState::Closed, TcpClientState::Open),
            _ => TcpClientState::Closed,
        }
    }
}

#[cfg(unix)]
fn is_under_way(error: &std::io::Error) -> bool {
    error.raw_os_error() == Some(rustix::io::Errno::INPROGRESS.raw_os_error())
}

#[cfg(not(unix))]
fn is_under_way(error: &std::io::Error) -> bool {
    error.kind() == std::io::ErrorKind::WouldBlock
}

/// Whether the socket has connected to itself: a call to an unused port can do so if it has the same local port.
fn calls_itself(socket: &Socket) -> bool {
    match (socket.local_addr(), socket.peer_addr()) {
        (Ok(local), Ok(peer)) => local.as_socket() == peer.as_socket(),
        _ => true,
    }
}

impl ByteStream for TcpClient {
    fn kind(&self) -> LineKind {
        LineKind::Client
    }

    fn open(&mut self) -> Connection {
        let mut state = std::mem::replace(&mut self.state, TcpClientState::Closed);
        if matches!(state, TcpClientState::Closed) {
            state = self.call();
        }
        if let TcpClientState::Calling(socket) = state {
            state = self.answer(socket);
        }
        self.state = state;
        match self.state {
            TcpClientState::Open(_) => Connection::Open,
            TcpClientState::Calling(_) => Connection::Calling,
            TcpClientState::Closed => Connection::Closed,
        }
    }

    fn receive(&mut self, room: usize, _fresh: bool) -> Received {
        let TcpClientState::Open(stream) = &mut self.state else { return Received::Nothing };
        stream.listen();
        if stream.has_input() {
            return Received::Bytes(stream.take(room));
        }
        if !stream.is_gone() {
            return Received::Nothing;
        }
        self.state = TcpClientState::Closed;
        Received::Ended
    }

    fn send(&mut self, bytes: &[u8]) -> SendResult {
        match &mut self.state {
            TcpClientState::Open(stream) => stream.send(bytes),
            _ => SendResult::Lost,
        }
    }

    fn close(&mut self) -> bool {
        matches!(std::mem::replace(&mut self.state, TcpClientState::Closed), TcpClientState::Open(stream) if !stream.is_gone())
    }

    fn shut_down(&mut self) {
        self.close();
    }

    fn apply(&mut self, setting: &LineSetting) -> Result<(), SettingRefusal> {
        let open = matches!(self.state, TcpClientState::Open(_));
        match setting {
            LineSetting::Nagle(on) => {
                self.nagle = *on;
                if let TcpClientState::Open(stream) = &mut self.state {
                    stream.set_nagle(*on);
                }
                return Ok(());
            }
            LineSetting::Port(_) | LineSetting::Target(_) if open => return Err(SettingRefusal::Busy),
            LineSetting::Port(port) => self.server.set_port(*port),
            LineSetting::Target(target) => self.server.set_ip(*target),
            _ => return Err(SettingRefusal::Value),
        }
        self.state = TcpClientState::Closed;
        Ok(())
    }
}
