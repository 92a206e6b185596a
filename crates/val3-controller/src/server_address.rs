//! Server of a controller, and the profile of the login: the part `profile@host:port` of an address.

use percent_encoding::percent_decode_str;

use crate::address::AddressFault;

/// Profile of a controller that exists by default (CS8C manual, page 107).
const DEFAULT_USER: &str = "default";

/// Server of a controller and profile of the login, without the password.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ServerAddress {
    /// Name of the profile on the controller.
    pub user: String,
    /// Name or number of the host; an IPv6 number without brackets.
    pub host: String,
    /// TCP port.
    pub port: u16,
}

impl ServerAddress {
    /// Parses `profile@host:port`. The profile and the port are optional.
    ///
    /// # Errors
    /// A part is missing or invalid, or the text contains a password.
    pub fn parse(text: &str, default_port: u16) -> Result<Self, AddressFault> {
        let (user, server) = text.rsplit_once('@').unwrap_or((DEFAULT_USER, text));
        if user.contains(':') {
            return Err(AddressFault::Password);
        }
        let (host, port) = host_and_port(server, default_port)?;
        let address = Self { user: decoded(user)?, host: decoded(host)?, port };
        match () {
            () if address.user.is_empty() => Err(AddressFault::User),
            () if !is_host(&address.host) => Err(AddressFault::Host),
            () => Ok(address),
        }
    }

    /// Host and port, for messages and URLs.
    #[must_use]
    pub fn place(&self) -> String {
        if self.host.contains(':') {
            format!("[{}]:{}", self.host, self.port)
        } else {
            format!("{}:{}", self.host, self.port)
        }
    }

    /// Whether both addresses name the same host and port. The profile of the login may differ.
    pub(crate) fn is_same_server(&self, other: &Self) -> bool {
        self.host.eq_ignore_ascii_case(&other.host) && self.port == other.port
    }
}

fn host_and_port(server: &str, default_port: u16) -> Result<(&str, u16), AddressFault> {
    let (host, port) = match server.strip_prefix('[') {
        Some(rest) => rest.split_once(']').ok_or(AddressFault::Host)?,
        None => server.split_at(server.find(':').unwrap_or(server.len())),
    };
    let port = match port.strip_prefix(':') {
        Some(number) => number.parse().ok().filter(|port| *port != 0).ok_or(AddressFault::Port)?,
        None if port.is_empty() => default_port,
        None => return Err(AddressFault::Host),
    };
    Ok((host, port))
}

fn is_host(text: &str) -> bool {
    !text.is_empty() && !text.contains(|character: char| character.is_whitespace() || "/[]@".contains(character))
}

/// Decodes a part of an address, such as `me%40shop`.
pub(crate) fn decoded(text: &str) -> Result<String, AddressFault> {
    let text = percent_decode_str(text).decode_utf8().map_err(|_| AddressFault::Text)?;
    if text.contains(char::is_control) { Err(AddressFault::Text) } else { Ok(text.into_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn servers_have_a_profile_and_a_port() {
        for (text, parts) in [
            ("robot", ("default", "robot", 21)),
            ("maintenance@192.168.0.254:851", ("maintenance", "192.168.0.254", 851)),
            ("me%40shop@[::1]", ("me@shop", "::1", 21)),
            ("[::1]:851", ("default", "::1", 851)),
        ] {
            let server = ServerAddress::parse(text, 21).unwrap();
            assert_eq!((server.user.as_str(), server.host.as_str(), server.port), parts, "{text}");
        }
        assert_eq!(ServerAddress::parse("[::1]", 21).unwrap().place(), "[::1]:21");
        assert_eq!(ServerAddress::parse("robot", 21).unwrap().place(), "robot:21");
    }

    #[test]
    fn wrong_servers_have_a_reason() {
        for (text, fault) in [
            ("", AddressFault::Host),
            ("a b", AddressFault::Host),
            ("robot/usr", AddressFault::Host),
            ("[::1", AddressFault::Host),
            ("@robot", AddressFault::User),
            ("robot:0", AddressFault::Port),
            ("robot:x", AddressFault::Port),
            ("me:secret@robot", AddressFault::Password),
            ("ro%0abot", AddressFault::Text),
        ] {
            assert_eq!(ServerAddress::parse(text, 21), Err(fault), "{text}");
        }
    }
}
