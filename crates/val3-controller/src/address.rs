//! Controller address: a server, or an emulator's folder.

use std::fmt::{self, Display};

use camino::Utf8PathBuf;

use crate::server_address::{ServerAddress, decoded};

/// Port of FTP.
const FTP_PORT: u16 = 21;

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
    /// Server and profile.
    pub server: ServerAddress,
    /// Folder of the server that contains `usr`: empty for its root, else with a slash before each name.
    pub base: String,
}

/// Reason why a text is no address.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AddressFault {
    /// Another protocol than FTP, with or without TLS.
    Protocol,
    /// No host, or a host with characters that no host has.
    Host,
    /// An empty profile.
    User,
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
            (Self::Ftp(one), Self::Ftp(other)) => one.server.is_same_server(&other.server) && one.base == other.base,
            _ => self == other,
        }
    }
}

impl FtpAddress {
    /// Parses the part after `ftp://` or `ftps://`.
    fn parse(rest: &str, is_encrypted: bool) -> Result<Self, AddressFault> {
        let (authority, path) = rest.split_once('/').unwrap_or((rest, ""));
        let server = ServerAddress::parse(authority, FTP_PORT)?;
        let names = path.split('/').filter(|name| !name.is_empty()).map(decoded);
        let base = names.map(|name| Ok(format!("/{}", name?))).collect::<Result<String, AddressFault>>()?;
        Ok(Self { is_encrypted, server, base })
    }
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
            Self::Ftp(FtpAddress { is_encrypted, server: ServerAddress { user, host, port }, base }) => {
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
            Self::User => "it names no profile before `@`",
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
        ControllerAddress::Ftp(FtpAddress { is_encrypted: false, server: ServerAddress { user, host, port }, base })
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
        assert!(matches!(
            &address,
            ControllerAddress::Ftp(FtpAddress { is_encrypted: true, server: ServerAddress { port: 21, .. }, .. })
        ));
        assert_eq!(address.to_string(), "ftps://me@robot");
        assert!(address.is_same_place(&ftp("default", "ROBOT", 21, "")));
        assert!(!address.is_same_place(&ftp("me", "robot", 2121, "")));
    }

    #[test]
    fn wrong_addresses_have_a_reason() {
        for (text, fault) in [
            ("ftp://", AddressFault::Host),
            ("ftp://robot/%0a", AddressFault::Text),
            ("ftp://robot:x", AddressFault::Port),
            ("http://robot", AddressFault::Protocol),
            ("ftps://me:secret@robot", AddressFault::Password),
        ] {
            assert_eq!(ControllerAddress::parse(text), Err(fault), "{text}");
        }
    }
}
