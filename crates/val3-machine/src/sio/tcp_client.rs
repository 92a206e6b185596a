//! Client socket. It reconnects after the end of a connection when the program continues.

use std::net::SocketAddr;

use socket2::{Domain, Protocol, Socket, Type};

use super::stream::Stream;
use super::{ByteStream, Connection, LineKind, NetworkAccess, Received, SendResult, Setting, SettingRefusal};

/// Client end of a TCP connection.
#[derive(Debug)]
pub struct TcpClient {
    server: SocketAddr,
    access: NetworkAccess,
    nagle: bool,
    state: State,
}

#[derive(Debug)]
enum State {
    Closed,
    Calling(Socket),
    Open(Stream),
}

impl TcpClient {
    /// Creates a client of `server`, which is called at the first read or write of the program (3.7.1).
    #[must_use]
    pub fn new(server: SocketAddr, access: NetworkAccess) -> Self {
        Self { server, access, nagle: true, state: State::Closed }
    }

    /// Starts to call.
    fn call(&self) -> State {
        let server = self.access.address(self.server);
        let socket = Socket::new(Domain::for_address(server), Type::STREAM, Some(Protocol::TCP));
        let Ok(socket) = socket.and_then(|socket| socket.set_nonblocking(true).map(|()| socket)) else {
            return State::Closed;
        };
        match socket.connect(&server.into()) {
            Err(error) if !is_under_way(&error) => State::Closed,
            _ => State::Calling(socket),
        }
    }

    /// Checks whether a server has accepted.
    fn answer(&self, socket: Socket) -> State {
        match socket.take_error() {
            Ok(None) if socket.peer_addr().is_err() => State::Calling(socket),
            Ok(None) if calls_itself(&socket) => State::Closed,
            Ok(None) => Stream::new(socket.into(), self.nagle).map_or(State::Closed, State::Open),
            _ => State::Closed,
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
        let mut state = std::mem::replace(&mut self.state, State::Closed);
        if matches!(state, State::Closed) {
            state = self.call();
        }
        if let State::Calling(socket) = state {
            state = self.answer(socket);
        }
        self.state = state;
        match self.state {
            State::Open(_) => Connection::Open,
            State::Calling(_) => Connection::Calling,
            State::Closed => Connection::Closed,
        }
    }

    fn receive(&mut self, room: usize, _fresh: bool) -> Received {
        let State::Open(stream) = &mut self.state else { return Received::Nothing };
        stream.listen();
        if stream.has_input() {
            return Received::Bytes(stream.take(room));
        }
        if !stream.is_gone() {
            return Received::Nothing;
        }
        self.state = State::Closed;
        Received::Ended
    }

    fn send(&mut self, bytes: &[u8]) -> SendResult {
        match &mut self.state {
            State::Open(stream) => stream.send(bytes),
            _ => SendResult::Lost,
        }
    }

    fn close(&mut self) -> bool {
        matches!(std::mem::replace(&mut self.state, State::Closed), State::Open(stream) if !stream.is_gone())
    }

    fn shut_down(&mut self) {
        self.close();
    }

    fn apply(&mut self, setting: &Setting) -> Result<(), SettingRefusal> {
        let open = matches!(self.state, State::Open(_));
        match setting {
            Setting::Nagle(on) => {
                self.nagle = *on;
                if let State::Open(stream) = &mut self.state {
                    stream.set_nagle(*on);
                }
                return Ok(());
            }
            Setting::Port(_) | Setting::Target(_) if open => return Err(SettingRefusal::Busy),
            Setting::Port(port) => self.server.set_port(*port),
            Setting::Target(target) => self.server.set_ip(*target),
            _ => return Err(SettingRefusal::Value),
        }
        self.state = State::Closed;
        Ok(())
    }
}
