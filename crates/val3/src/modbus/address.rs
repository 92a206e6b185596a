//! Argument of `--modbus`.

use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::str::FromStr;

use crate::serve::socket_address;
use crate::user_error::UserError;

/// Default port. The port in the file is usually 502, for which a process needs rights.
const PORT: u16 = 1502;

/// Address of a Modbus server.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ModbusAddress(SocketAddr);

impl FromStr for ModbusAddress {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let address = if text.is_empty() { Some((Ipv4Addr::LOCALHOST, PORT).into()) } else { socket_address(text) };
        let usage = "write ADDRESS:PORT, for example 127.0.0.1:1502, and the application before --modbus";
        address.map(Self).ok_or_else(|| usage.to_owned())
    }
}

impl ModbusAddress {
    /// Listens on the address. Another port is never chosen, because clients are configured for one port.
    ///
    /// # Errors
    /// The port is in use or needs rights, or the address does not belong to this machine.
    pub(super) fn listen(self) -> Result<TcpListener, UserError> {
        TcpListener::bind(self.0).map_err(|error| {
            UserError::new(format!("cannot serve Modbus at {}: {error}", self.0))
                .with_help("choose an address of this machine and a free port from 1024, or port 0 for any free one")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_is_a_port_of_this_machine() {
        let parse = |text: &str| text.parse::<ModbusAddress>().map(|address| address.0.to_string());
        assert_eq!(parse("").as_deref(), Ok("127.0.0.1:1502"));
        assert_eq!(parse("502").as_deref(), Ok("127.0.0.1:502"));
        assert_eq!(parse("0.0.0.0:1502").as_deref(), Ok("0.0.0.0:1502"));
        assert!(parse("usrapp/main").unwrap_err().contains("before --modbus"));
    }
}
