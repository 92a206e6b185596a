//! Address of the server: the argument of `--controller`.

use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::str::FromStr;

use crate::serve::socket_address;
use crate::user_error::UserError;

/// Default port: the port of older controllers. The port 851 of newer controllers needs rights of the system.
const PORT: u16 = 5653;

/// Value of `--controller`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct SoapAddress(SocketAddr);

impl FromStr for SoapAddress {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.is_empty() {
            return Ok(Self((Ipv4Addr::LOCALHOST, PORT).into()));
        }
        let address = socket_address(text)
            .ok_or("write ADDRESS:PORT, for example 127.0.0.1:5653, and the application before --controller")?;
        Ok(Self(address))
    }
}

impl SoapAddress {
    /// Listens on the address. There is no substitute for a port that is in use, because clients expect this port.
    ///
    /// # Errors
    /// The port is in use or reserved for the system, or the address does not belong to this machine.
    pub(super) fn listen(self) -> Result<TcpListener, UserError> {
        TcpListener::bind(self.0).map_err(|error| {
            UserError::new(format!("clients of the controller cannot be served on {}: {error}", self.0)).with_help(
                "name another port, for example --controller 5654 (0 for a free one), and set it in the client",
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_port_alone_is_that_of_this_machine() {
        let parsed = |text: &str| text.parse::<SoapAddress>().map(|address| address.0.to_string());
        assert_eq!(parsed(""), Ok("127.0.0.1:5653".to_owned()));
        assert_eq!(parsed("851"), Ok("127.0.0.1:851".to_owned()));
        assert_eq!(parsed("0.0.0.0:851"), Ok("0.0.0.0:851".to_owned()));
        assert!(parsed("cell").unwrap_err().contains("before --controller"));
    }

    #[test]
    fn a_used_port_is_an_error() {
        let taken = TcpListener::bind("127.0.0.1:0").unwrap();
        let error = SoapAddress(taken.local_addr().unwrap()).listen().unwrap_err().to_string();
        assert!(error.contains("name another port"), "{error}");
    }
}
