//! Access to the files of a controller, independent of the transport.

use std::fmt::{self, Display};

use crate::certificate::CertificateFingerprint;
use crate::path::{ControllerPath, NameFault};

/// Files of a controller. Each call is one operation on the controller. Only [`list`](Self::list) and [`read`](Self::read),
/// which change nothing, may be repeated on a new connection if the controller has closed the connection meanwhile.
pub trait ControllerFiles {
    /// Host and port, or the folder, for messages.
    fn place(&self) -> &str;

    /// Returns the entries of a folder, sorted by name.
    ///
    /// # Errors
    /// If the folder cannot be listed, or a name is not allowed.
    fn list(&mut self, folder: &ControllerPath) -> Result<Vec<ListedEntry>, AccessError>;

    /// Returns the content of a file with at most `limit` bytes.
    ///
    /// # Errors
    /// If the file cannot be read or is longer.
    fn read(&mut self, file: &ControllerPath, limit: u64) -> Result<Vec<u8>, AccessError>;

    /// Writes a file, and replaces its content if it exists.
    ///
    /// # Errors
    /// If the file cannot be written. It may then have a part of the content.
    fn write(&mut self, file: &ControllerPath, bytes: &[u8]) -> Result<(), AccessError>;

    /// Renames a file. A controller may reject it if the new name exists.
    ///
    /// # Errors
    /// If the file cannot be renamed.
    fn rename(&mut self, from: &ControllerPath, to: &ControllerPath) -> Result<(), AccessError>;

    /// Removes a file.
    ///
    /// # Errors
    /// If the file cannot be removed.
    fn remove(&mut self, file: &ControllerPath) -> Result<(), AccessError>;

    /// Creates a folder.
    ///
    /// # Errors
    /// If the folder cannot be created.
    fn make_folder(&mut self, folder: &ControllerPath) -> Result<(), AccessError>;

    /// Removes an empty folder.
    ///
    /// # Errors
    /// If the folder cannot be removed.
    fn remove_folder(&mut self, folder: &ControllerPath) -> Result<(), AccessError>;

    /// Establishes the connection once more after an error.
    ///
    /// # Errors
    /// If the controller cannot be reached.
    fn reconnect(&mut self) -> Result<(), AccessError>;
}

/// Entry of a folder on a controller.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct ListedEntry {
    /// Path of the entry.
    pub path: ControllerPath,
    /// Whether the entry is a folder.
    pub is_folder: bool,
}

/// Failed operation on a controller.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AccessError {
    /// The operation, for example "read `usr/configs/arm.cfx`".
    pub step: String,
    /// Host and port, or the folder.
    pub place: String,
    /// Cause.
    pub reason: AccessFault,
}

/// Cause of a failed operation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum AccessFault {
    /// The controller has rejected the command.
    Rejected {
        /// Code of the reply, for example 550.
        code: u32,
        /// Text of the reply.
        text: String,
    },
    /// The connection failed or was lost.
    Connection(String),
    /// The controller has closed the connection.
    Closed,
    /// An encrypted data connection has ended without the mark of TLS (`close_notify`).
    CutOff,
    /// The controller does not offer TLS.
    NoTls {
        /// Code of the reply, for example 502.
        code: u32,
        /// Text of the reply.
        text: String,
    },
    /// The controller identifies itself by a certificate that was not accepted before.
    UnknownCertificate(CertificateFingerprint),
    /// The controller identifies itself by another certificate than the accepted one.
    OtherCertificate {
        /// Accepted certificate.
        expected: CertificateFingerprint,
        /// Certificate of the controller.
        found: CertificateFingerprint,
    },
    /// No encrypted connection was established, or the controller has not proved that it has the certificate's key.
    Handshake(String),
    /// In active mode, the controller has not connected to this computer. Empty, or the reply.
    NoDataConnection(String),
    /// The controller did not respond in time.
    Timeout,
    /// An entry of a folder is neither a file nor a folder.
    Special(String),
    /// A line of a listing has no known form.
    Listing(String),
    /// A name that is not used as a file name.
    Name(NameFault),
    /// A file or listing with more bytes than the limit.
    TooLarge(u64),
    /// Error of the file system.
    FileSystem(String),
}

impl AccessError {
    /// Whether the controller has rejected the command permanently.
    pub(crate) fn is_rejection(&self) -> bool {
        matches!(self.reason, AccessFault::Rejected { code: 500..=599, .. })
    }

    /// Whether the controller has closed the connection, for example because it was idle for long (421).
    pub(crate) fn is_closed(&self) -> bool {
        matches!(self.reason, AccessFault::Closed | AccessFault::Rejected { code: 421, .. })
    }

    /// Whether no further command can be sent, because replies may be unread.
    pub(crate) fn ends_connection(&self) -> bool {
        let is_lost = matches!(
            self.reason,
            AccessFault::Connection(_)
                | AccessFault::Timeout
                | AccessFault::Handshake(_)
                | AccessFault::OtherCertificate { .. }
                | AccessFault::NoDataConnection(_)
        );
        is_lost || self.is_closed()
    }

    /// Whether a transfer was interrupted, so that an unknown number of replies may follow.
    pub(crate) fn interrupts_transfer(&self) -> bool {
        matches!(self.reason, AccessFault::TooLarge(_))
    }

    /// Whether only this file or folder cannot be read, so that others can.
    pub(crate) fn is_of_one_entry(&self) -> bool {
        let is_denied = matches!(self.reason, AccessFault::Rejected { code: 450 | 550..=553, .. });
        is_denied || matches!(self.reason, AccessFault::FileSystem(_) | AccessFault::Special(_))
    }
}

impl AccessError {
    /// Remedy; empty if the message contains it.
    pub(crate) fn help(&self) -> &'static str {
        match &self.reason {
            AccessFault::Rejected { code: 530, .. } => {
                "check the profile and its password: `connectionPassword`, not `password`"
            }
            AccessFault::Rejected { code: 550 | 553, .. } => {
                "the profile needs `readAccess`, and for a push `writeAccess`; a loaded application can refuse too"
            }
            AccessFault::Rejected { code: 452 | 552, .. } => {
                "the controller is full: remove applications that are not used"
            }
            AccessFault::Connection(_) | AccessFault::Timeout => {
                "check the cable, the address and that the controller is on"
            }
            AccessFault::Closed | AccessFault::Rejected { code: 421, .. } => {
                "repeat the command; a controller closes connections that are idle for long, and may allow only a few"
            }
            AccessFault::CutOff => {
                "repeat the command; if this happens again, the controller does not end transfers as TLS requires, or another \
                 device cuts them off"
            }
            AccessFault::NoTls { .. } => {
                "switch TLS on in the controller, or write `ftp://` instead of `ftps://`, which is not encrypted: only in the \
                 network of the cell"
            }
            AccessFault::UnknownCertificate(_) => {
                "compare the fingerprint with the certificate on the controller; if it is the same, repeat the command with \
                 `--fingerprint FINGERPRINT`, which `val3 pull` remembers"
            }
            AccessFault::OtherCertificate { .. } => {
                "another device may be answering. If the controller was repaired, replaced or updated, compare the first \
                 fingerprint with its certificate, and accept it with `val3 pull --fingerprint FINGERPRINT`"
            }
            AccessFault::Handshake(_) => {
                "the controller needs TLS 1.2 or 1.3 and the key of its certificate; `ftp://` is not encrypted: use it only in \
                 the network of the cell"
            }
            AccessFault::NoDataConnection(_) => {
                "let the firewall of this computer accept connections from the controller, or use the passive mode: \
                 `val3 pull --passive`"
            }
            AccessFault::Special(_) | AccessFault::Name(_) => {
                "rename or remove it on the controller, or name applications with --app"
            }
            _ => "",
        }
    }
}

impl Display for AccessError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot {} at {}: {}", self.step, self.place, self.reason)
    }
}

impl Display for AccessFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rejected { code, text } => write!(f, "{code} {text}"),
            Self::Connection(reason) => write!(f, "the connection failed: {reason}"),
            Self::Closed => f.write_str("the controller has closed the connection"),
            Self::CutOff => f.write_str("the transfer has ended without the mark of TLS, so that it may be incomplete"),
            Self::NoTls { code, text } => write!(f, "the controller does not offer TLS: {code} {text}"),
            Self::UnknownCertificate(found) => write!(f, "its certificate is not known: {found}"),
            Self::OtherCertificate { expected, found } => {
                write!(f, "its certificate is {found}, and the accepted one is {expected}")
            }
            Self::Handshake(reason) => write!(f, "no encrypted connection was established: {reason}"),
            Self::NoDataConnection(reply) if reply.is_empty() => {
                f.write_str("the controller has not opened the data connection to this computer")
            }
            Self::NoDataConnection(reply) => {
                write!(f, "the controller cannot open the data connection to this computer: {reply}")
            }
            Self::Timeout => f.write_str("the controller does not respond in time"),
            Self::Special(name) => write!(f, "`{name}` is a link or a device, which is not followed"),
            Self::Listing(line) => write!(f, "the line {line:?} of the listing has no known form"),
            Self::Name(fault) => write!(f, "{fault}"),
            Self::TooLarge(limit) => write!(f, "it has more than {limit} bytes"),
            Self::FileSystem(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for AccessError {}
