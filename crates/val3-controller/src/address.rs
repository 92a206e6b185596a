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

/// Address of an FTP server, with or without TLS, and without the password.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FtpAddress {
    /// Whether the connections are encrypted by TLS: `ftps://`.
    pub is_encrypted: bool,
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
    /// Another protocol than FTP, with or without TLS.
    Protocol,
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
    /// Parses `ftp://user@host:port/path`, the same with `ftps://`, or the path of a folder.
    ///
    /// # Errors
    /// If the text has the form of a URL, but is not a valid address.
    pub fn parse(text: &str) -> Result<Self, AddressFault> {
        match text.split_once("://") {
            None => Ok(Self::Folder(text.into())),
            Some((scheme, rest)) if scheme.eq_ignore_ascii_case("ftp") => FtpAddress::parse(rest, false).map(Self::Ftp),
            Some((scheme, rest)) if scheme.eq_ignore_ascii_case("ftps") => FtpAddress::parse(rest, true).map(Self::Ftp),
            Some(_) => Err(AddressFault::Protocol),
        }
    }
}

impl ControllerAddress {
    /// Whether both addresses lead to the same files. The profile of the login and the encryption may differ.
    pub(crate) fn is_same_place(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Ftp(one), Self::Ftp(other)) => one.is_same_server(other) && one.base == other.base,
            _ => self == other,
        }
    }
}

impl FtpAddress {
    /// Whether both addresses name the same host and port.
    pub(crate) fn is_same_server(&self, other: &Self) -> bool {
        self.host.eq_ignore_ascii_case(&other.host) && self.port == other.port
    }

    /// Parses the part after `ftp://` or `ftps://`.
    fn parse(rest: &str, is_encrypted: bool) -> Result<Self, AddressFault> {
        let (authority, path) = rest.split_once('/').unwrap_or((rest, ""));
        let (user, server) = authority.rsplit_once('@').unwrap_or((DEFAULT_USER, authority));
        if user.contains(':') {
            return Err(AddressFault::Password);
        }
        let (host, port) = host_and_port(server)?;
        let names = path.split('/').filter(|name| !name.is_empty()).map(decoded);
        let base = names.map(|name| Ok(format!("/{}", name?))).collect::<Result<String, AddressFault>>()?;
        let address = Self { is_encrypted, user: decoded(user)?, host: decoded(host)?, port, base };
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
            Self::Ftp(FtpAddress { is_encrypted, user, host, port, base }) => {
                write!(f, "{}://{}@", if *is_encrypted { "ftps" } else { "ftp" }, encoded(user))?;
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
            Self::Protocol => "only `ftp://` and `ftps://` addresses and folders are supported",
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
        let [user, host, base] = [user, host, base].map(str::to_owned);
        ControllerAddress::Ftp(FtpAddress { is_encrypted: false, user, host, port, base })
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
    fn an_address_with_tls_leads_to_the_same_files() {
        let address = ControllerAddress::parse("FTPS://me@robot").unwrap();
        assert!(matches!(&address, ControllerAddress::Ftp(FtpAddress { is_encrypted: true, port: 21, .. })));
        assert_eq!(address.to_string(), "ftps://me@robot");
        assert!(address.is_same_place(&ftp("default", "ROBOT", 21, "")));
        assert!(!address.is_same_place(&ftp("me", "robot", 2121, "")));
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
            ("ftps://me:secret@robot", AddressFault::Password),
        ] {
            assert_eq!(ControllerAddress::parse(text), Err(fault), "{text}");
        }
    }
}
