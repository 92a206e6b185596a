//! Access control: secrets in addresses, and the permitted hosts and origins of requests.

use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr};

use axum::http::header::{HOST, ORIGIN};
use axum::http::{HeaderMap, HeaderName, Method, Request};
use constant_time_eq::constant_time_eq;

use crate::secret;
use crate::user_error::UserError;

/// Role of a viewer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ViewerRole {
    /// Views and operates the run.
    Operator,
    /// Only views the run.
    Guest,
}

/// Resource of the server.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Resource {
    /// `/SECRET/`.
    Page,
    /// `/SECRET/socket`.
    Socket,
}

/// Secrets and address of a server.
pub(super) struct Access {
    operator: String,
    guest: String,
    address: SocketAddr,
}

/// Permitted request.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Grant {
    pub(super) role: ViewerRole,
    pub(super) resource: Resource,
    /// Host in the request, which is a host of this server.
    pub(super) host: String,
}

impl Access {
    /// Creates the access to a server at this address, with random or chosen secrets.
    ///
    /// # Errors
    /// The chosen secret is too short, or the system has no random numbers.
    pub(super) fn new(address: SocketAddr) -> Result<Self, UserError> {
        let [operator, guest] = secret::for_page(["operator", "guest"])?;
        Ok(Self { operator, guest, address })
    }

    /// Secret of a role.
    pub(super) fn secret(&self, role: ViewerRole) -> &str {
        match role {
            ViewerRole::Operator => &self.operator,
            ViewerRole::Guest => &self.guest,
        }
    }

    /// Checks a request. A rejection has no reason, so that strangers get no information.
    pub(super) fn grant<B>(&self, request: &Request<B>) -> Option<Grant> {
        let (secret, rest) = request.uri().path().strip_prefix('/')?.split_once('/')?;
        let role = self.role(secret)?;
        let resource = match rest {
            "" => Resource::Page,
            "socket" => Resource::Socket,
            _ => return None,
        };
        let host = single(request.headers(), HOST).filter(|host| self.is_host(host))?;
        let is_plain = request.method() == Method::GET && request.uri().authority().is_none();
        let is_own = resource == Resource::Page || self.is_origin(request.headers(), host);
        (is_plain && is_own).then(|| Grant { role, resource, host: host.to_owned() })
    }

    /// Returns the role for a secret. Both comparisons are always executed, in constant time.
    fn role(&self, secret: &str) -> Option<ViewerRole> {
        let [is_operator, is_guest] =
            [&self.operator, &self.guest].map(|known| constant_time_eq(known.as_bytes(), secret.as_bytes()));
        match (is_operator, is_guest) {
            (true, _) => Some(ViewerRole::Operator),
            (false, true) => Some(ViewerRole::Guest),
            (false, false) => None,
        }
    }

    /// Whether a host is a host of this server. Pages of other servers whose name resolves to this machine (DNS
    /// rebinding) have another host.
    fn is_host(&self, host: &str) -> bool {
        let (address, port) = match host.parse::<SocketAddr>() {
            Ok(named) => (Some(named.ip()), named.port()),
            Err(_) => match host.strip_prefix("localhost") {
                Some("") => (None, 80),
                Some(port) => (None, port.strip_prefix(':').and_then(|port| port.parse().ok()).unwrap_or_default()),
                None => (host.trim_matches(['[', ']']).parse().ok(), if is_address(host) { 80 } else { 0 }),
            },
        };
        port == self.address.port() && address.is_none_or(|named| self.is_served(named))
    }

    /// Whether an address is served. If the server listens on all addresses, every address is valid, because only names
    /// can be rebound to another machine.
    fn is_served(&self, named: IpAddr) -> bool {
        let served = self.address.ip();
        let is_local = named == Ipv4Addr::LOCALHOST || named == Ipv6Addr::LOCALHOST;
        named == served || served.is_unspecified() || served.is_loopback() && is_local
    }

    /// Whether a request has this server as its origin. Browsers send the origin of the page that opens a socket, and
    /// only the page of this server may open it.
    fn is_origin(&self, headers: &HeaderMap, host: &str) -> bool {
        single(headers, ORIGIN).and_then(|origin| origin.strip_prefix("http://")).is_some_and(|origin| origin == host)
    }
}

fn is_address(host: &str) -> bool {
    host.trim_matches(['[', ']']).parse::<IpAddr>().is_ok()
}

/// Value of a header; `None` if it does not occur exactly once.
fn single(headers: &HeaderMap, name: HeaderName) -> Option<&str> {
    let mut values = headers.get_all(name).iter();
    values.next().filter(|_| values.next().is_none())?.to_str().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn access(address: &str) -> Access {
        Access { operator: "0a".to_owned(), guest: "0b".to_owned(), address: address.parse().unwrap() }
    }

    fn grant(access: &Access, path: &str, host: &str, origin: &str) -> Option<(ViewerRole, Resource)> {
        let mut request = Request::get(path).header(HOST, host);
        if !origin.is_empty() {
            request = request.header(ORIGIN, origin);
        }
        access.grant(&request.body(()).unwrap()).map(|grant| (grant.role, grant.resource))
    }

    #[test]
    fn a_secret_gives_a_role() {
        let access = access("127.0.0.1:8303");
        let page = |path| grant(&access, path, "127.0.0.1:8303", "");
        assert_eq!(page("/0a/"), Some((ViewerRole::Operator, Resource::Page)));
        assert_eq!(page("/0b/"), Some((ViewerRole::Guest, Resource::Page)));
        for path in ["/", "/0a", "//", "/0/", "/0c/", "/0A/", "/0a/x", "/0a//", "/0a/../0a/", "/0a/%2e%2e/", "/x/0a/"] {
            assert_eq!(page(path), None, "{path}");
        }
    }

    #[test]
    fn roles_have_different_secrets() {
        let access = Access::new("127.0.0.1:1".parse().unwrap()).unwrap();
        assert_ne!(access.operator, access.guest);
    }

    #[test]
    fn a_socket_needs_the_origin_of_the_page() {
        let access = access("127.0.0.1:8303");
        let socket = |host, origin| grant(&access, "/0a/socket", host, origin).is_some();
        assert!(socket("127.0.0.1:8303", "http://127.0.0.1:8303"));
        assert!(socket("localhost:8303", "http://localhost:8303"));
        for origin in
            ["", "null", "http://localhost:8303", "https://127.0.0.1:8303", "http://127.0.0.1:8304", "http://x"]
        {
            assert!(!socket("127.0.0.1:8303", origin), "{origin}");
        }
    }

    #[test]
    fn a_host_is_an_address_of_the_server() {
        let names = [
            "127.0.0.1:80",
            "localhost",
            "127.0.0.1",
            "[::1]",
            "192.168.0.7",
            "evil.example",
            "localhost.evil.example:80",
        ];
        assert_eq!(are_hosts("127.0.0.1:80", &names), [true, true, true, true, false, false, false]);
        assert_eq!(are_hosts("0.0.0.0:80", &names), [true, true, true, true, true, false, false]);
        let names = ["127.0.0.1:8303", "192.168.0.7:8303", "192.168.0.7", "192.168.0.8:8303", "cell:8303", ""];
        assert_eq!(are_hosts("192.168.0.7:8303", &names), [false, true, false, false, false, false]);
    }

    /// Whether each name is a host of the server at the address.
    fn are_hosts(address: &str, hosts: &[&str]) -> Vec<bool> {
        let access = access(address);
        hosts.iter().map(|host| access.is_host(host)).collect()
    }

    #[test]
    fn other_requests_are_refused() {
        let access = access("127.0.0.1:8303");
        let host = "127.0.0.1:8303";
        assert!(access.grant(&Request::post("/0a/").header(HOST, host).body(()).unwrap()).is_none());
        assert!(access.grant(&Request::get("http://x/0a/").header(HOST, host).body(()).unwrap()).is_none());
        assert!(access.grant(&Request::get("/0a/").body(()).unwrap()).is_none());
        let twice = Request::get("/0a/").header(HOST, host).header(HOST, "x");
        assert!(access.grant(&twice.body(()).unwrap()).is_none());
    }
}
