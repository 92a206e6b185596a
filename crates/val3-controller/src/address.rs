//! Address of a controller: a server, or the folder of an emulator.

use std::fmt::{self, Display};

use camino::Utf8PathBuf;
use percent_encoding::percent_decode_str;

/// Port of FTP.
const FTP_PORT: u16 = 21;

/// Profile of a controller that exists by default (CS8C manual, page 107).
const DEFAULT_USER: &str = "default";

/// Address of a controller.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ControllerAddress {
    /// A server.
    Ftp(FtpAddress),
    /// A folder that contains `usr`, for example of an SRS emulator.
    Folder(Utf8PathBuf),
}

/// Address of an FTP server, without the password.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FtpAddress {
    /// Name of the profile on the controller.
    pub user: String,
    /// Name or number of the host; an IPv6 number without brackets.
    pub host: String,
    /// TCP port.
    pub port: u16,
    /// Folder of the server that contains `usr`: empty for its root, else with a slash before each name.
    pub base: String,
}

/// Reason why a text is no address.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AddressFault {
    /// Another protocol than FTP.
    Protocol,
    /// FTP over TLS, which is not supported.
    Tls,
    /// No host.
    Host,
    /// The port is no number from 1 to 65535.
    Port,
    /// The address contains a password.
    Password,
    /// A part is not UTF-8 after decoding, or has control characters.
    Text,
}

impl ControllerAddress {
    /// Parses `ftp://user@host:port/path`, or the path of a folder.
    ///
    /// # Errors
    /// If the text has the form of a URL, but is not a valid address.
    pub fn parse(text: &str) -> Result<Self, AddressFault> {
        match text.split_once("://") {
            None => Ok(Self::Folder(text.into())),
            Some((scheme, rest)) if scheme.eq_ignore_ascii_case("ftp") => FtpAddress::parse(rest).map(Self::Ftp),
            Some((scheme, _)) if scheme.eq_ignore_ascii_case("ftps") => Err(AddressFault::Tls),
            Some(_) => Err(AddressFault::Protocol),
        }
    }
}

impl ControllerAddress {
    /// Whether both addresses lead to the same files. The profile of the login may differ.
    pub(crate) fn is_same_place(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Ftp(one), Self::Ftp(other)) => {
                one.host.eq_ignore_ascii_case(&other.host) && (one.port, &one.base) == (other.port, &other.base)
            }
            _ => self == other,
        }
    }
}

impl FtpAddress {
    /// Parses the part after `ftp://`.
    fn parse(rest: &str) -> Result<Self, AddressFault> {
        let (authority, path) = rest.split_once('/').unwrap_or((rest, ""));
        let (user, server) = authority.rsplit_once('@').unwrap_or((DEFAULT_USER, authority));
        if user.contains(':') {
            return Err(AddressFault::Password);
        }
        let (host, port) = host_and_port(server)?;
        let names = path.split('/').filter(|name| !name.is_empty()).map(decoded);
        let base = names.map(|name| Ok(format!("/{}", name?))).collect::<Result<String, AddressFault>>()?;
        let address = Self { user: decoded(user)?, host: decoded(host)?, port, base };
        if address.host.is_empty() { Err(AddressFault::Host) } else { Ok(address) }
    }

    /// Host and port, for messages.
    pub(crate) fn place(&self) -> String {
        if self.host.contains(':') {
            format!("[{}]:{}", self.host, self.port)
        } else {
            format!("{}:{}", self.host, self.port)
        }
    }
}

fn host_and_port(server: &str) -> Result<(&str, u16), AddressFault> {
    let (host, port) = match server.strip_prefix('[') {
        Some(rest) => rest.split_once(']').ok_or(AddressFault::Host)?,
        None => server.split_at(server.find(':').unwrap_or(server.len())),
    };
    let port = match port.strip_prefix(':') {
        Some(number) => number.parse().ok().filter(|port| *port != 0).ok_or(AddressFault::Port)?,
        None if port.is_empty() => FTP_PORT,
        None => return Err(AddressFault::Host),
    };
    Ok((host, port))
}

fn decoded(text: &str) -> Result<String, AddressFault> {
    let text = percent_decode_str(text).decode_utf8().map_err(|_| AddressFault::Text)?;
    if text.contains(char::is_control) { Err(AddressFault::Text) } else { Ok(text.into_owned()) }
}

fn encoded(text: &str) -> impl Display {
    const RESERVED: &percent_encoding::AsciiSet =
        &percent_encoding::CONTROLS.add(b' ').add(b'%').add(b'@').add(b':').add(b'/').add(b'#').add(b'?');
    percent_encoding::utf8_percent_encode(text, RESERVED)
}

impl Display for ControllerAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Folder(folder) => write!(f, "{folder}"),
            Self::Ftp(FtpAddress { user, host, port, base }) => {
                write!(f, "ftp://{}@", encoded(user))?;
                if host.contains(':') { write!(f, "[{host}]") } else { write!(f, "{host}") }?;
                if *port != FTP_PORT {
                    write!(f, ":{port}")?;
                }
                base.split('/').filter(|name| !name.is_empty()).try_for_each(|name| write!(f, "/{}", encoded(name)))
            }
        }
    }
}

impl Display for AddressFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Protocol => "only `ftp://` addresses and folders are supported",
            Self::Tls => "FTP over TLS is not supported",
            Self::Host => "it names no host",
            Self::Port => "the port is no number from 1 to 65535",
            Self::Password => "a password does not belong in an address, which is stored and shown",
            Self::Text => "a part is not UTF-8, or has control characters",
        })
    }
}

impl std::error::Error for AddressFault {}

#[cfg(test)]
mod tests {
    use super::*;

    fn ftp(user: &str, host: &str, port: u16, base: &str) -> ControllerAddress {
        ControllerAddress::Ftp(FtpAddress { user: user.to_owned(), host: host.to_owned(), port, base: base.to_owned() })
    }

    #[test]
    fn addresses_are_read_and_shown() {
        for (text, address) in [
            ("ftp://maintenance@192.168.0.254", ftp("maintenance", "192.168.0.254", 21, "")),
            ("ftp://default@robot:2121/cells/a%20b", ftp("default", "robot", 2121, "/cells/a b")),
            ("ftp://me%40shop@[::1]:2121", ftp("me@shop", "::1", 2121, "")),
            ("cells/Controller1", ControllerAddress::Folder("cells/Controller1".into())),
        ] {
            assert_eq!(ControllerAddress::parse(text), Ok(address.clone()), "{text}");
            assert_eq!(address.to_string(), text);
        }
        assert_eq!(ControllerAddress::parse("FTP://robot/"), Ok(ftp("default", "robot", 21, "")));
    }

    #[test]
    fn wrong_addresses_have_a_reason() {
        for (text, fault) in [
            ("ftp://", AddressFault::Host),
            ("ftp://robot:0", AddressFault::Port),
            ("ftp://robot:x", AddressFault::Port),
            ("ftp://me:secret@robot", AddressFault::Password),
            ("ftp://[::1", AddressFault::Host),
            ("ftp://ro%0abot", AddressFault::Text),
            ("http://robot", AddressFault::Protocol),
            ("ftps://robot", AddressFault::Tls),
        ] {
            assert_eq!(ControllerAddress::parse(text), Err(fault), "{text}");
        }
    }
}
