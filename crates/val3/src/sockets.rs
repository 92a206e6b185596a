//! Sockets whose ports only the cell names: announced in runs, closed in tests. Also notes on all external access of a
//! run.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::io::{self, IsTerminal};
use std::net::SocketAddr;
use std::sync::{Arc, Mutex, PoisonError};

use val3_machine::sio::{LineKind, SocketGuard, SocketRequest};

use crate::output::to_stderr;

/// Receiver of announcements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum AnnouncementReader {
    /// The user at a terminal, if there is one.
    Terminal,
    /// The user of a debugger.
    Debugger,
}

/// Announces each connection to a port of this machine once, before it is made. In CI and without a terminal, such
/// connections are rejected, because no user would see what the cell sends to another program.
#[derive(Debug)]
pub(crate) struct Announcements {
    is_read: bool,
    /// Whether a test is debugged, in which no such socket opens.
    is_test: bool,
    reader: AnnouncementReader,
    announced: RefCell<BTreeSet<(String, SocketAddr)>>,
    /// Texts for the debugger.
    texts: RefCell<String>,
}

impl Announcements {
    pub(crate) fn new(reader: AnnouncementReader) -> Self {
        let is_ci = std::env::var_os("CI").is_some_and(|value| !value.is_empty() && value != "false");
        let is_read = !is_ci && (reader == AnnouncementReader::Debugger || io::stderr().is_terminal());
        Self { is_read, is_test: false, reader, announced: RefCell::default(), texts: RefCell::default() }
    }

    /// Announcements of a debugged test.
    pub(crate) fn of_test() -> Self {
        Self { is_read: false, is_test: true, ..Self::new(AnnouncementReader::Debugger) }
    }

    /// Returns the texts since the last call, for the debugger.
    pub(crate) fn take_texts(&self) -> Option<String> {
        Some(self.texts.take()).filter(|texts| !texts.is_empty())
    }

    fn announce(&self, SocketRequest { link, kind, address }: SocketRequest<'_>) {
        if !self.announced.borrow_mut().insert((link.to_owned(), address)) {
            return;
        }
        let text = if self.is_test {
            closed(&[link])
        } else if self.is_read {
            format!("note: `{link}` connects to port {} of this machine, which only the cell names", address.port())
        } else {
            let port = address.port();
            let end = if kind == LineKind::Udp { format!("udp:{port}") } else { format!("client:{address}") };
            format!(
                "note: `{link}` is not connected to port {port} of this machine, because only the cell names it\n  \
                 help: name it with --line '{link}={end}', or allow all connections with --network"
            )
        };
        match self.reader {
            AnnouncementReader::Terminal => to_stderr(|out| writeln!(out, "{text}")),
            // Writing to a string cannot fail.
            AnnouncementReader::Debugger => _ = writeln!(self.texts.borrow_mut(), "{text}"),
        }
    }
}

impl SocketGuard for Announcements {
    fn admits(&self, request: SocketRequest<'_>) -> bool {
        // A server only accepts connections from programs that use its port.
        if request.kind == LineKind::Server && !self.is_test {
            return true;
        }
        self.announce(request);
        self.is_read
    }
}

/// Prints the external access that was granted to a run.
pub(crate) fn note_grants(grants: &[String]) {
    to_stderr(|out| grants.iter().try_for_each(|grant| writeln!(out, "note: {grant}")));
}

/// Lines that tests have used without a connection. All threads share the list.
#[derive(Debug, Clone, Default)]
pub(crate) struct ClosedSockets {
    links: Arc<Mutex<BTreeSet<String>>>,
}

impl ClosedSockets {
    /// Prints the unconnected lines, once.
    pub(crate) fn report(&self) {
        let links = self.links.lock().unwrap_or_else(PoisonError::into_inner);
        if !links.is_empty() {
            let links: Vec<&str> = links.iter().map(String::as_str).collect();
            to_stderr(|out| writeln!(out, "{}", closed(&links)));
        }
    }
}

/// Note on the unconnected lines of tests.
fn closed(links: &[&str]) -> String {
    let listed: Vec<String> = links.iter().map(|link| format!("`{link}`")).collect();
    let first = links.first().copied().unwrap_or_default();
    format!(
        "note: sockets are not connected in tests: {}\n  help: let the script of the test be the other end, or name the \
         connection with --line '{first}=server:PORT'",
        listed.join(", ")
    )
}

impl SocketGuard for ClosedSockets {
    fn admits(&self, request: SocketRequest<'_>) -> bool {
        let mut links = self.links.lock().unwrap_or_else(PoisonError::into_inner);
        if !links.contains(request.link) {
            links.insert(request.link.to_owned());
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(kind: LineKind) -> SocketRequest<'static> {
        SocketRequest { link: r"Socket\host", kind, address: ([127, 0, 0, 1], 6379).into() }
    }

    #[test]
    fn a_connection_is_announced_once() {
        let guard = Announcements { is_read: true, ..Announcements::new(AnnouncementReader::Debugger) };
        assert!(guard.admits(request(LineKind::Client)) && guard.admits(request(LineKind::Client)));
        let text = "note: `Socket\\host` connects to port 6379 of this machine, which only the cell names\n";
        assert_eq!((guard.take_texts().as_deref(), guard.take_texts()), (Some(text), None));
    }

    #[test]
    fn unread_announcements_refuse_connections_but_no_callers() {
        let guard = Announcements { is_read: false, ..Announcements::new(AnnouncementReader::Debugger) };
        assert!(!guard.admits(request(LineKind::Client)) && guard.admits(request(LineKind::Server)));
        assert!(guard.take_texts().unwrap().contains(r"--line 'Socket\host=client:127.0.0.1:6379'"));
        let guard = Announcements { is_read: false, ..Announcements::new(AnnouncementReader::Debugger) };
        assert!(!guard.admits(request(LineKind::Udp)));
        assert!(guard.take_texts().unwrap().contains(r"--line 'Socket\host=udp:6379'"));
    }

    #[test]
    fn no_socket_of_a_test_opens() {
        let guard = ClosedSockets::default();
        assert!([LineKind::Client, LineKind::Server, LineKind::Udp].iter().all(|kind| !guard.admits(request(*kind))));
        assert_eq!(guard.links.lock().unwrap().len(), 1);
    }
}
