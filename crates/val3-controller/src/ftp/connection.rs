//! Connection and login.

use std::io::ErrorKind;
use std::net::{SocketAddr, TcpStream, ToSocketAddrs as _};
use std::time::Duration;

use suppaftp::types::{FileType, Mode};
use suppaftp::{FtpError, FtpStream, Status};

use super::FtpTimeouts;
use super::listing::ListingCommand;
use crate::access::AccessFault;
use crate::address::FtpAddress;

/// Failed step of a connection.
pub(super) struct ConnectFailure {
    pub(super) step: &'static str,
    pub(super) reason: AccessFault,
}

/// Connects, logs in, selects the binary type, and determines the listing command.
pub(super) fn connect(
    address: &FtpAddress,
    password: &str,
    timeouts: FtpTimeouts,
) -> Result<(FtpStream, ListingCommand), ConnectFailure> {
    let at = |step| move |reason| ConnectFailure { step, reason };
    let socket = socket(address, timeouts).map_err(at("connect"))?;
    let is_ipv6 = socket.peer_addr().is_ok_and(|peer| peer.is_ipv6());
    let ftp = FtpStream::connect_with_stream(socket).map_err(fault).map_err(at("connect"))?;
    let mut ftp = ftp.passive_stream_builder(move |peer| open(peer, timeouts).map_err(FtpError::ConnectionError));
    ftp.set_mode(if is_ipv6 { Mode::ExtendedPassive } else { Mode::Passive });
    // The data connection goes to the controller, whatever address its reply names.
    ftp.set_passive_nat_workaround(true);
    ftp.login(address.user.as_str(), password).map_err(fault).map_err(at("log in"))?;
    ftp.transfer_type(FileType::Binary).map_err(fault).map_err(at("select binary transfers"))?;
    let listing = listing_command(&mut ftp).map_err(at("query the features"))?;
    Ok((ftp, listing))
}

/// Opens the control connection to the first address that accepts it.
fn socket(address: &FtpAddress, timeouts: FtpTimeouts) -> Result<TcpStream, AccessFault> {
    let resolved = (address.host.as_str(), address.port).to_socket_addrs();
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
    let limit: Option<Duration> = Some(timeouts.transfer);
    socket.set_read_timeout(limit)?;
    socket.set_write_timeout(limit)?;
    socket.set_nodelay(true)?;
    Ok(socket)
}

/// Returns the listing command according to `FEAT`.
///
/// `FtpStream::feat` waits for a second line if a server has no features. With an expected status that no reply has,
/// the complete reply is part of the error.
fn listing_command(ftp: &mut FtpStream) -> Result<ListingCommand, AccessFault> {
    match ftp.custom_command("FEAT", &[Status::RestartMarker]) {
        Err(FtpError::UnexpectedResponse(reply)) => {
            let text = String::from_utf8_lossy(&reply.body).to_ascii_uppercase();
            let has_mlsd = text.lines().any(|line| matches!(line.split_whitespace().next(), Some("MLST" | "MLSD")));
            Ok(if has_mlsd { ListingCommand::Mlsd } else { ListingCommand::List })
        }
        Err(error) => Err(fault(error)),
        Ok(_) => Ok(ListingCommand::List),
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

fn network_fault(error: &std::io::Error) -> AccessFault {
    match error.kind() {
        // Sockets report the end of a read timeout as either kind.
        ErrorKind::TimedOut | ErrorKind::WouldBlock => AccessFault::Timeout,
        _ => AccessFault::Connection(error.to_string()),
    }
}
