//! Network access of sockets.

use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr};

/// Machines with which the sockets of a run may communicate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum NetworkAccess {
    /// Only programs on this machine: every address in a program or configuration means this machine.
    #[default]
    Loopback,
    /// Any machine with the address.
    Network,
}

impl NetworkAccess {
    /// Returns the address to use for an address in a program.
    #[must_use]
    pub fn address(self, named: SocketAddr) -> SocketAddr {
        match (self, named.ip()) {
            (Self::Network, _) => named,
            (Self::Loopback, ip) if ip.is_loopback() => named,
            (Self::Loopback, IpAddr::V4(_)) => SocketAddr::new(Ipv4Addr::LOCALHOST.into(), named.port()),
            (Self::Loopback, IpAddr::V6(_)) => SocketAddr::new(Ipv6Addr::LOCALHOST.into(), named.port()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_network_every_address_is_this_machine() {
        let reached = |access: NetworkAccess, named: &str| access.address(named.parse().unwrap()).to_string();
        assert_eq!(reached(NetworkAccess::Loopback, "192.168.0.254:80"), "127.0.0.1:80");
        assert_eq!(reached(NetworkAccess::Loopback, "0.0.0.0:80"), "127.0.0.1:80");
        assert_eq!(reached(NetworkAccess::Loopback, "127.0.0.7:80"), "127.0.0.7:80");
        assert_eq!(reached(NetworkAccess::Loopback, "[2001:db8::1]:80"), "[::1]:80");
        assert_eq!(reached(NetworkAccess::Network, "192.168.0.254:80"), "192.168.0.254:80");
    }
}
