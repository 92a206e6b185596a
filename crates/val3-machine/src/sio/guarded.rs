//! Socket whose port the user has not named: each connection requires the permission of a guard.

use std::fmt::Debug;
use std::net::SocketAddr;
use std::rc::Rc;

use super::{
    ByteStream, ChannelConfig, Connection, LineKind, LineSetting, NetworkAccess, Received, SendResult, SettingRefusal,
};

/// Socket that is about to be opened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SocketRequest<'a> {
    /// The link of the line: `Socket\host`.
    pub link: &'a str,
    /// The kind of socket.
    pub kind: LineKind,
    /// Address to which a client connects or a UDP socket sends; for a server the address at which it listens.
    pub address: SocketAddr,
}

/// Decides whether sockets may be opened.
pub trait SocketGuard: Debug {
    /// Whether the socket may be opened. The call is repeated as long as the program uses the line.
    fn admits(&self, request: SocketRequest<'_>) -> bool;
}

/// Guarded socket. Without permission it behaves as if no peer existed.
#[derive(Debug)]
pub(super) struct GuardedSocket<L> {
    socket: L,
    link: String,
    /// Address in the configuration or the program.
    named: SocketAddr,
    access: NetworkAccess,
    guard: Rc<dyn SocketGuard>,
}

impl<L: ByteStream> GuardedSocket<L> {
    /// Guards a socket of the line `config`, whose parameters are still to be applied.
    pub(super) fn new(socket: L, config: &ChannelConfig, access: NetworkAccess, guard: Rc<dyn SocketGuard>) -> Self {
        Self { socket, link: config.link.clone(), named: SocketAddr::from(([127, 0, 0, 1], 0)), access, guard }
    }
}

impl<L: ByteStream> ByteStream for GuardedSocket<L> {
    fn kind(&self) -> LineKind {
        self.socket.kind()
    }

    fn open(&mut self) -> Connection {
        let address = self.access.address(self.named);
        let request = SocketRequest { link: &self.link, kind: self.socket.kind(), address };
        if self.guard.admits(request) { self.socket.open() } else { Connection::Closed }
    }

    fn receive(&mut self, room: usize, fresh: bool) -> Received {
        self.socket.receive(room, fresh)
    }

    fn send(&mut self, bytes: &[u8]) -> SendResult {
        self.socket.send(bytes)
    }

    fn close(&mut self) -> bool {
        self.socket.close()
    }

    fn shut_down(&mut self) {
        self.socket.shut_down();
    }

    fn apply(&mut self, setting: &LineSetting) -> Result<(), SettingRefusal> {
        self.socket.apply(setting)?;
        match setting {
            LineSetting::Port(port) => self.named.set_port(*port),
            LineSetting::Target(target) => self.named.set_ip(*target),
            _ => {}
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;
    use std::net::TcpListener;

    use super::*;
    use crate::sio::Channel;

    /// Admits even ports.
    #[derive(Debug, Default)]
    struct Even(RefCell<Vec<String>>);

    impl SocketGuard for Even {
        fn admits(&self, SocketRequest { link, kind, address }: SocketRequest<'_>) -> bool {
            self.0.borrow_mut().push(format!("{link} {kind:?} {address}"));
            address.port() % 2 == 0
        }
    }

    #[test]
    fn a_guard_is_asked_for_the_port_that_counts() {
        let guard = Rc::new(Even::default());
        let settings = vec![LineSetting::Port(7), LineSetting::Target([10, 9, 8, 7].into())];
        let config = ChannelConfig { link: r"Socket\host".to_owned(), kind: LineKind::Client, settings };
        let mut channel: Channel =
            config.channel(config.guarded(NetworkAccess::Loopback, guard.clone()).unwrap()).unwrap();
        channel.attend();
        channel.set(&LineSetting::Port(9)).unwrap();
        channel.attend();
        assert_eq!(*guard.0.borrow(), [r"Socket\host Client 127.0.0.1:7", r"Socket\host Client 127.0.0.1:9"]);
    }

    #[test]
    fn nothing_is_connected_without_consent() {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        listener.set_nonblocking(true).unwrap();
        let port = listener.local_addr().unwrap().port();
        #[derive(Debug)]
        struct Never;
        impl SocketGuard for Never {
            fn admits(&self, _: SocketRequest<'_>) -> bool {
                false
            }
        }
        let settings = vec![LineSetting::Port(port)];
        for kind in [LineKind::Client, LineKind::Server, LineKind::Udp] {
            let config = ChannelConfig { link: r"Socket\host".to_owned(), kind, settings: settings.clone() };
            let mut line = config.guarded(NetworkAccess::Loopback, Rc::new(Never)).unwrap();
            settings.iter().for_each(|setting| line.apply(setting).unwrap());
            assert_eq!(line.open(), Connection::Closed);
        }
        assert!(listener.accept().is_err(), "nothing has called");
    }
}
