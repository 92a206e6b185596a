//! Connection, encryption and login.

use std::io::ErrorKind;
use std::net::{SocketAddr, TcpStream, ToSocketAddrs as _};
use std::time::Duration;

use suppaftp::types::{FileType, Mode};
use suppaftp::{FtpError, ImplFtpStream};

use super::tls::{AcceptedCertificate, TlsSession, TlsSocket};
use crate::access::AccessFault;
use crate::address::FtpAddress;
use crate::certificate::CertificateFingerprint;
use crate::connection_settings::{ConnectionSettings, FtpTimeouts};

/// Client of a server with or without TLS.
pub(super) type FtpClient = ImplFtpStream<TlsSocket>;

/// Code of the reply to a server that cannot open the data connection (RFC 959, 4.2).
const NO_DATA_CONNECTION: u32 = 425;

/// Code of the reply with which a server closes the connection.
const CLOSING: u32 = 421;

/// A control connection after the login.
pub(super) struct Connection {
    pub(super) client: FtpClient,
    /// `None` without encryption.
    tls: Option<TlsSession>,
    is_active: bool,
    timeouts: FtpTimeouts,
}

/// Failed step of a connection.
pub(super) struct ConnectFailure {
    pub(super) step: &'static str,
    pub(super) reason: AccessFault,
}

/// Returns an error of a step.
fn failed_at(step: &'static str) -> impl Fn(AccessFault) -> ConnectFailure {
    move |reason| ConnectFailure { step, reason }
}

/// Connects, establishes TLS if the address requires it, logs in, and selects the binary type. At an encrypted server,
/// the login requires an accepted certificate.
pub(super) fn connect(
    address: &FtpAddress,
    password: &str,
    settings: ConnectionSettings,
    timeouts: FtpTimeouts,
) -> Result<Connection, ConnectFailure> {
    let tls = match (address.is_encrypted, settings.fingerprint) {
        (false, _) => None,
        (true, Some(fingerprint)) => Some(AcceptedCertificate::Only(fingerprint)),
        (true, None) => {
            let found = presented_certificate(address, timeouts)?;
            return Err(failed_at(SECURE)(AccessFault::UnknownCertificate(found)));
        }
    };
    let socket = socket(address, timeouts).map_err(failed_at("connect"))?;
    let is_ipv6 = socket.peer_addr().is_ok_and(|peer| peer.is_ipv6());
    let client = FtpClient::connect_with_stream(socket).map_err(fault).map_err(failed_at("connect"))?;
    let (client, tls) = match tls {
        None => (client, None),
        Some(accepted) => secure(client, address, accepted, timeouts).map(|(client, tls)| (client, Some(tls)))?,
    };
    let mut client = client.passive_stream_builder(move |peer| open(peer, timeouts).map_err(FtpError::ConnectionError));
    client.set_mode(if is_ipv6 { Mode::ExtendedPassive } else { Mode::Passive });
    // The address in the reply is ignored: a router may translate it, and data come only from the controller.
    client.set_passive_nat_workaround(true);
    if settings.is_active {
        client = client.active_mode(timeouts.connect);
    }
    client.login(address.server.user.as_str(), password).map_err(fault).map_err(failed_at("log in"))?;
    client.transfer_type(FileType::Binary).map_err(fault).map_err(failed_at("select binary transfers"))?;
    Ok(Connection { client, tls, is_active: settings.is_active, timeouts })
}

/// Step of the handshake.
const SECURE: &str = "start TLS";

/// Returns the certificate whose key the server has, without a login.
pub(super) fn presented_certificate(
    address: &FtpAddress,
    timeouts: FtpTimeouts,
) -> Result<CertificateFingerprint, ConnectFailure> {
    let socket = socket(address, timeouts).map_err(failed_at("connect"))?;
    let client = FtpClient::connect_with_stream(socket).map_err(fault).map_err(failed_at("connect"))?;
    let (mut client, tls) = secure(client, address, AcceptedCertificate::Any, timeouts)?;
    // The server may close the connection instead of a reply.
    let _ = client.quit();
    tls.proved().ok_or_else(|| failed_at(SECURE)(AccessFault::Handshake("no certificate was sent".to_owned())))
}

/// Encrypts the control connection, and from now on all data connections. There is no fallback to plain text.
fn secure(
    client: FtpClient,
    address: &FtpAddress,
    accepted: AcceptedCertificate,
    timeouts: FtpTimeouts,
) -> Result<(FtpClient, TlsSession), ConnectFailure> {
    let tls = TlsSession::new(accepted, timeouts.transfer).map_err(failed_at(SECURE))?;
    let error = match client.into_secure(tls.clone(), &address.server.host) {
        Ok(client) => return Ok((client, tls)),
        Err(error) => error,
    };
    if let Some(reason) = tls.take_fault() {
        return Err(failed_at(SECURE)(reason));
    }
    Err(match fault(error) {
        reason if tls.proved().is_some() => failed_at("encrypt the data connections")(reason),
        AccessFault::Rejected { code, text } if code != CLOSING => failed_at(SECURE)(AccessFault::NoTls { code, text }),
        reason => failed_at(SECURE)(reason),
    })
}

/// Opens the control connection to the first address that accepts it.
fn socket(address: &FtpAddress, timeouts: FtpTimeouts) -> Result<TcpStream, AccessFault> {
    let resolved = (address.server.host.as_str(), address.server.port).to_socket_addrs();
    let resolved = resolved.map_err(|error| AccessFault::Connection(error.to_string()))?;
    let mut reason = AccessFault::Connection("the host has no address".to_owned());
    for peer in resolved {
        match open(peer, timeouts) {
            Ok(socket) => return Ok(socket),
            Err(error) => reason = network_fault(&error),
        }
    }
    Err(reason)
}

fn open(peer: SocketAddr, timeouts: FtpTimeouts) -> std::io::Result<TcpStream> {
    let socket = TcpStream::connect_timeout(&peer, timeouts.connect)?;
    limit(&socket, timeouts.transfer)?;
    socket.set_nodelay(true)?;
    Ok(socket)
}

/// Limits the time without a byte.
fn limit(socket: &TcpStream, time: Duration) -> std::io::Result<()> {
    socket.set_read_timeout(Some(time))?;
    socket.set_write_timeout(Some(time))
}

impl Connection {
    /// Limits the time of a data connection. The client limits passive connections only.
    pub(super) fn limit(&self, socket: &TcpStream) -> Result<(), AccessFault> {
        limit(socket, self.timeouts.transfer).map_err(|error| network_fault(&error))
    }

    /// Converts an error of a command that opens a data connection.
    pub(super) fn opening_fault(&self, error: FtpError) -> AccessFault {
        match error {
            FtpError::SecureError(text) => {
                let known = self.tls.as_ref().and_then(TlsSession::take_fault);
                known.unwrap_or(AccessFault::Handshake(text))
            }
            error if !self.is_active => fault(error),
            error => match fault(error) {
                // The client waits for the server, or the server for its connection.
                AccessFault::Timeout => AccessFault::NoDataConnection(String::new()),
                AccessFault::Rejected { code: code @ NO_DATA_CONNECTION, text } => {
                    AccessFault::NoDataConnection(format!("{code} {text}"))
                }
                reason => reason,
            },
        }
    }
}

/// Converts an error of the client.
pub(super) fn fault(error: FtpError) -> AccessFault {
    match error {
        FtpError::UnexpectedResponse(reply) => {
            let text = String::from_utf8_lossy(&reply.body);
            let text = text.trim();
            let (code, text) = match text.get(..3).and_then(|digits| digits.parse().ok()) {
                Some(code) => (code, text.get(4..).unwrap_or_default()),
                None => (reply.status.code(), text),
            };
            AccessFault::Rejected { code, text: text.to_owned() }
        }
        FtpError::ConnectionError(error) => network_fault(&error),
        FtpError::BadResponse => AccessFault::Connection("a reply is not FTP".to_owned()),
        error => AccessFault::Connection(error.to_string()),
    }
}

/// Converts an error of a data connection. Its end is no end of the control connection.
pub(super) fn data_fault(error: &std::io::Error) -> AccessFault {
    match network_fault(error) {
        // An end without encryption is no error.
        AccessFault::Closed if error.kind() == ErrorKind::UnexpectedEof => AccessFault::CutOff,
        AccessFault::Closed => AccessFault::Connection(error.to_string()),
        reason => reason,
    }
}

fn network_fault(error: &std::io::Error) -> AccessFault {
    match error.kind() {
        // Sockets report the end of a read timeout as either kind.
        ErrorKind::TimedOut | ErrorKind::WouldBlock => AccessFault::Timeout,
        ErrorKind::UnexpectedEof
        | ErrorKind::ConnectionReset
        | ErrorKind::ConnectionAborted
        | ErrorKind::BrokenPipe => AccessFault::Closed,
        _ => AccessFault::Connection(error.to_string()),
    }
}
