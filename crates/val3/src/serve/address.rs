//! Server address: the argument of `--serve`, and the chosen port.

use std::net::{IpAddr, Ipv4Addr, SocketAddr, TcpListener};
use std::str::FromStr;

use crate::user_error::UserError;

/// Default port. If the port is in use, the system chooses another.
const PORT: u16 = 8303;

/// Value of `--serve`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ServeAddress {
    address: SocketAddr,
    /// Whether the user has set the address, so that no other port may be used.
    is_given: bool,
}

impl Default for ServeAddress {
    fn default() -> Self {
        Self { address: (Ipv4Addr::LOCALHOST, PORT).into(), is_given: false }
    }
}

impl FromStr for ServeAddress {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.is_empty() {
            return Ok(Self::default());
        }
        let usage = "write ADDRESS:PORT, for example 127.0.0.1:8303, and the application before --serve";
        let address = socket_address(text).ok_or(usage)?;
        Ok(Self { address, is_given: true })
    }
}

/// Parses an address with a port. A port without an address is a port of this machine.
pub(crate) fn socket_address(text: &str) -> Option<SocketAddr> {
    let text = text.strip_prefix("localhost:").unwrap_or(text);
    let local = text.parse().map(|port: u16| SocketAddr::from((Ipv4Addr::LOCALHOST, port)));
    local.ok().or_else(|| text.parse().ok())
}

impl ServeAddress {
    /// Listens on the address, or on a free port if the user has set none and the default port is in use.
    ///
    /// # Errors
    /// The port is in use, or the address does not belong to this machine.
    pub(super) fn listen(self) -> Result<TcpListener, UserError> {
        let listener = TcpListener::bind(self.address);
        let listener = match listener {
            Err(_) if !self.is_given => TcpListener::bind((self.address.ip(), 0)),
            listener => listener,
        };
        listener.map_err(|error| {
            UserError::new(format!("cannot serve on {}: {error}", self.address))
                .with_help("choose an address of this machine and another port, or port 0 for a free one")
        })
    }
}

/// Address at which this machine can reach the server.
pub(crate) fn reachable(address: SocketAddr) -> SocketAddr {
    match address.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => (Ipv4Addr::LOCALHOST, address.port()).into(),
        IpAddr::V6(ip) if ip.is_unspecified() => (std::net::Ipv6Addr::LOCALHOST, address.port()).into(),
        _ => address,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &str) -> String {
        text.parse::<ServeAddress>().map_or_else(|error| error, |address| address.address.to_string())
    }

    #[test]
    fn a_port_alone_is_that_of_this_machine() {
        assert_eq!(parsed("8080"), "127.0.0.1:8080");
        assert_eq!(parsed("localhost:8080"), "127.0.0.1:8080");
        assert_eq!(parsed("0.0.0.0:80"), "0.0.0.0:80");
        assert_eq!(parsed("[::1]:0"), "[::1]:0");
        assert!(parsed("cell/usr/usrapp/main").contains("before --serve"));
    }

    #[test]
    fn only_the_usual_port_has_a_substitute() {
        let taken = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = taken.local_addr().unwrap();
        assert!(ServeAddress { address, is_given: true }.listen().is_err());
        let listener = ServeAddress { address, is_given: false }.listen().unwrap();
        assert_ne!(listener.local_addr().unwrap(), address);
        assert!(listener.local_addr().unwrap().ip().is_loopback());
    }
}
